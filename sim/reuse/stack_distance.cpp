#include "sim/reuse/stack_distance.h"

#include <algorithm>

namespace artu::sim {

/// Fenwick's tree: counts_[i] is of the times of which i is the last, as many as i's lowest bit.
void StackDistance::set(std::size_t time, int by) {
  for (std::size_t i = time + 1; i < counts_.size(); i += i & (~i + 1)) {
    counts_[i] += static_cast<std::uint32_t>(by);
  }
}

std::uint64_t StackDistance::up_to(std::size_t time) const {
  std::uint64_t sum = 0;
  for (std::size_t i = time + 1; i != 0; i &= i - 1) sum += counts_[i];
  return sum;
}

/// Numbers the places anew, so that times do not grow with the requests.
void StackDistance::compact() {
  std::vector<std::pair<std::size_t, std::uint64_t>> order;
  order.reserve(last_.size());
  for (const auto& [line, time] : last_) order.push_back({time, line});
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> holes(free_.begin(), free_.end());
  free_.clear();
  std::size_t hole = 0;
  now_ = 0;
  for (const auto& [time, line] : order) {
    for (; hole < holes.size() && holes[hole] < time; ++hole) free_.insert(free_.end(), now_++);
    last_[line] = now_++;
  }
  for (; hole < holes.size(); ++hole) free_.insert(free_.end(), now_++);
  counts_.assign(std::max<std::size_t>(2 * now_, 1024) + 1, 0);
  for (std::size_t time = 0; time < now_; ++time) set(time, 1);
}

std::uint64_t StackDistance::use(std::uint64_t line) {
  if (now_ + 1 >= counts_.size()) compact();
  const auto [known, fresh] = last_.try_emplace(line, now_);
  std::uint64_t distance = never_used;
  const std::size_t hole = free_.empty() ? 0 : *free_.rbegin();
  if (fresh) {
    // The topmost free place takes what is pushed down, in all caches that reach to it.
    if (free_.empty()) {
      ++places_;
    } else {
      set(hole, -1);
      free_.erase(hole);
    }
  } else {
    const std::size_t before = known->second;
    distance = places_ - up_to(before);
    if (!free_.empty() && hole > before) {
      // Caches that miss the line use the free place; in those that hold it a place as deep as the line's stays free.
      set(hole, -1);
      free_.erase(hole);
      free_.insert(before);
    } else {
      set(before, -1);
    }
    known->second = now_;
  }
  set(now_++, 1);
  return distance;
}

void StackDistance::forget(std::uint64_t line) {
  const auto known = last_.find(line);
  if (known == last_.end()) return;
  free_.insert(known->second);
  last_.erase(known);
}

void StackDistance::clear() {
  last_.clear();
  free_.clear();
  counts_.clear();
  now_ = places_ = 0;
}

}  // namespace artu::sim
