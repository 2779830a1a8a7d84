// A ray's traversal stack: the newest entries are held on chip, what overflows is spilled to memory or forgotten.
//
// With spilling, entries below `held` lie in memory and come back a line at a time.  With a restart trail they are
// gone: for every level of the path the ray knows which child it is at, and starts anew from the roots, skipping the
// children that are done (Laine, "Restart trail for stackless BVH traversal", HPG 2010; for wide nodes a count a level,
// Vaidyanathan et al., "Wide BVH traversal with a short stack", HPG 2019).  That is exact since the children of a node
// come by rising `enter` and a nearer hit only cuts off the last of them: the first k are the same at every visit.
#pragma once

#include <array>

#include "hw/datapath/node_visit.h"

namespace artu::hw {

/// Entries a ray may have in all, and levels of its path, the roots' included: a tree that needs more is refused.
inline constexpr std::uint32_t maximum_stack = 128;

class RayStack {
 public:
  /// `trail`: where what overflows is forgotten; else none is kept.
  void clear(bool trail) {
    size_ = held_ = depth_ = resumed_ = 0;
    keeps_trail_ = trail;
  }

  // Steps on chip, and below them.
  bool empty() const { return size_ == held_; }
  bool overflown() const { return held_ != 0; }
  std::uint32_t on_chip() const { return size_ - held_; }
  /// `n` more entries at the bottom are spilled, or forgotten.
  void give_up(std::uint32_t n) { held_ += n; }
  /// `n` entries come back from memory.
  void refill(std::uint32_t n) { held_ -= n; }
  /// Number of the lowest entry that is on chip.
  std::uint32_t bottom() const { return held_; }

  /// Child `order` of the node at the ray's depth waits; `last` if it is the last one that the ray meets there.
  void push(const Step& step, std::uint32_t order, bool last) {
    entries_[size_++] = {step, static_cast<std::uint8_t>(depth_), trail_of(order, last)};
  }
  const Step& top() const { return entries_[size_ - 1].step; }
  void pop() {
    const Entry& entry = entries_[--size_];
    if (!keeps_trail_) return;
    depth_ = entry.level;
    trail_[depth_++] = entry.trail;
    resumed_ = 0;
  }

  // The trail: trail_[l] says at which child of the node of level l the ray is; the roots are level 0.
  /// How many children of the node at the ray's depth are done.
  std::uint32_t done() const { return depth_ < resumed_ ? trail_[depth_] & order_mask : 0; }
  /// The ray goes on into child `order` of that node.
  void descend(std::uint32_t order, bool last) {
    if (keeps_trail_) trail_[depth_++] = trail_of(order, last);
  }
  /// Everything on chip is done and more was forgotten: from the roots again, to the sibling that comes next.
  void restart() {
    while ((trail_[depth_ - 1] & last_bit) != 0) --depth_;
    ++trail_[depth_ - 1];
    resumed_ = depth_;
    size_ = held_ = depth_ = 0;
  }

 private:
  static constexpr std::uint8_t last_bit = 128, order_mask = 127;
  static std::uint8_t trail_of(std::uint32_t order, bool last) {
    return static_cast<std::uint8_t>(order | (last ? last_bit : 0));
  }
  struct Entry {
    Step step;
    std::uint8_t level, trail;
  };
  std::uint32_t size_ = 0, held_ = 0;
  std::uint32_t depth_ = 0;    // level of the node that is visited
  std::uint32_t resumed_ = 0;  // levels below this are passed again after a restart
  bool keeps_trail_ = false;
  std::array<Entry, maximum_stack> entries_;
  std::array<std::uint8_t, maximum_stack + 32> trail_;
};

}  // namespace artu::hw
