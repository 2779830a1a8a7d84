#include "hw/memory/tree_builder.h"

#include <algorithm>

namespace artu::hw {

namespace {
constexpr std::uint64_t reference_bytes = 16;

std::uint64_t lines_for(std::uint64_t bytes) { return (bytes + line_bytes - 1) / line_bytes; }

std::uint64_t ceil_log2(std::uint64_t n) {
  std::uint64_t levels = 0;
  while ((std::uint64_t{1} << levels) < n) ++levels;
  return levels;
}
}  // namespace

void TreeBuilder::reset() {
  steps_.clear();
  step_ = stream_ = 0;
  line_ = 0;
  outstanding_ = 0;
  active_ = false;
  builds_ = triangles_ = lines_read_ = lines_written_ = 0;
}

void TreeBuilder::plan() {
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint64_t n = frame.dynamic_triangle_count;
  const std::uint64_t references = lines_for(n * reference_bytes);
  const std::uint64_t levels = std::max<std::uint64_t>(1, ceil_log2(n));
  const std::uint64_t held = ceil_log2(config_.triangles_per_pass);
  const std::uint64_t streamed = levels > held ? levels - held : 0;
  const std::uint64_t level_cycles = n * config_.cycles_per_triangle;
  steps_.clear();
  steps_.push_back({{{frame.build_input, n, false}, {frame.build_scratch, references, true}}, n});
  for (std::uint64_t level = 0; level < streamed; ++level) {
    steps_.push_back(
        {{{frame.build_scratch, references, false}, {frame.build_scratch, references, true}}, level_cycles});
  }
  steps_.push_back({{{frame.build_scratch, references, false},
                     {frame.build_input, n, false},
                     {frame.dynamic_nodes, frame.dynamic_node_lines, true},
                     {frame.dynamic_triangles, frame.dynamic_reference_count, true},
                     {frame.dynamic_attributes, n, true}},
                    level_cycles * (levels - streamed)});
}

/// The next line of the step's streams, if there is one and room for it.
bool TreeBuilder::issue() {
  Step& step = steps_[step_];
  while (stream_ < step.streams.size() && line_ == step.streams[stream_].lines) {
    ++stream_;
    line_ = 0;
  }
  if (stream_ == step.streams.size() || outstanding_ == config_.outstanding || !memory_->request.can_push())
    return false;
  const Stream& stream = step.streams[stream_];
  memory_->request.push({stream.base + line_ * line_bytes, stream.write ? ~std::uint64_t{0} : 0, 0, 0});
  ++line_;
  ++outstanding_;
  ++(stream.write ? lines_written_ : lines_read_);
  return true;
}

Activity TreeBuilder::tick(Cycle now) {
  bool moved = false;
  if (memory_->response.can_pop()) {
    memory_->response.pop();
    --outstanding_;
    moved = true;
  }
  if (!active_) {
    if (!build_->can_pop()) return {moved ? State::busy : State::stall_in, moved ? now + 1 : never};
    build_->pop();
    plan();
    step_ = stream_ = 0;
    line_ = 0;
    computed_at_ = now + steps_[0].compute;
    active_ = true;
    ++builds_;
    triangles_ += registers_.descriptor.dynamic_triangle_count;
    moved = true;
  }
  if (issue()) moved = true;
  const bool all_issued = stream_ == steps_[step_].streams.size();
  if (all_issued && outstanding_ == 0 && now >= computed_at_) {
    if (step_ + 1 < steps_.size()) {
      ++step_;
      stream_ = 0;
      line_ = 0;
      computed_at_ = now + steps_[step_].compute;
      moved = true;
    } else if (built_->can_push()) {
      built_->push({});
      active_ = false;
      moved = true;
    }
  }
  if (moved) return {State::busy, now + 1};
  if (now < computed_at_) return {State::busy, computed_at_};
  return {State::stall_mem};
}

void TreeBuilder::report(Statistics& out) const {
  out.push_back({path(), "builds", builds_, "", "trees built"});
  out.push_back({path(), "triangles", triangles_, "", "triangles in them"});
  out.push_back({path(), "lines_read", lines_read_, "lines", "read from memory"});
  out.push_back({path(), "lines_written", lines_written_, "lines", "written to memory"});
}

std::string TreeBuilder::describe() const {
  return "step " + std::to_string(step_) + " of " + std::to_string(steps_.size()) + ", " +
         std::to_string(outstanding_) + " requests outstanding";
}

}  // namespace artu::hw
