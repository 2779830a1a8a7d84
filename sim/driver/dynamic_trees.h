// The trees of the dynamic geometry, frame by frame, as the unit's builder makes them.
//
// Frames are independent of each other.  With refit a frame takes its nodes from its base, a frame that depends on the
// frame's index alone: the last one whose index is a multiple of `refit_interval`, or where the source begins later or
// leaves that one out its next one.  A base is built anew, also where nothing has moved; so is a frame whose number of
// triangles is not its base's.
#pragma once

#include <functional>
#include <optional>

#include "sim/driver/tree.h"
#include "traces/frame.h"

namespace artu::sim {

/// The frame of the index, or if there is none the first one after it.
using FrameFrom = std::function<traces::Frame(std::uint32_t index)>;

struct DynamicTree {
  Tree tree;
  bool moved = true;      // it is made in this frame
  bool refitted = false;  // from the nodes of another frame
};

class DynamicTrees {
 public:
  /// `frames` is needed for refit alone.
  DynamicTrees(const TreeRecipe& recipe, FrameFrom frames) : recipe_(recipe), frames_(std::move(frames)) {}

  DynamicTree of(const traces::Frame& frame, const std::string& where);

 private:
  struct Base {
    std::uint32_t wanted, index;  // as asked for; as there is
    std::size_t triangles;
    Tree tree;
  };
  const Base& base_of(const traces::Frame& frame, const std::string& where);

  const TreeRecipe recipe_;
  const FrameFrom frames_;
  std::optional<Base> base_;  // of the last frame
};

}  // namespace artu::sim
