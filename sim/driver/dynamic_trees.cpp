#include "sim/driver/dynamic_trees.h"

#include <stdexcept>

#include "sim/driver/tree_refit.h"

namespace artu::sim {

const DynamicTrees::Base& DynamicTrees::base_of(const traces::Frame& frame, const std::string& where) {
  const std::uint32_t wanted = frame.index - frame.index % recipe_.builder.refit_interval;
  if (base_ && base_->wanted == wanted) return *base_;
  const auto make = [&](const traces::Frame& base) {
    base_ = Base{wanted, base.index, base.dynamic.triangle_count(), build_tree(base.dynamic, recipe_, true, where)};
  };
  if (frame.index == wanted) {
    make(frame);
  } else {
    if (!frames_) throw std::logic_error("refit: no source of frames to take nodes from");
    make(frames_(wanted));
  }
  return *base_;
}

DynamicTree DynamicTrees::of(const traces::Frame& frame, const std::string& where) {
  if (!recipe_.builder.refit) return {build_tree(frame.dynamic, recipe_, true, where), frame.dynamic_moved, false};
  const Base& base = base_of(frame, where);
  if (base.index == frame.index) return {base.tree, true, false};
  if (base.triangles != frame.dynamic.triangle_count())
    return {build_tree(frame.dynamic, recipe_, true, where), frame.dynamic_moved, false};
  DynamicTree result{base.tree, frame.dynamic_moved, true};
  refit(frame.dynamic, result.tree);
  return result;
}

}  // namespace artu::sim
