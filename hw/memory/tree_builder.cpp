#include "hw/memory/tree_builder.h"

namespace artu::hw {

void TreeBuilder::reset() {
  steps_.clear();
  issued_.clear();
  step_ = 0;
  left_ = 0;
  outstanding_ = 0;
  builds_ = refits_ = triangles_ = lines_read_ = lines_written_ = 0;
  stage_cycles_ = {};
}

void TreeBuilder::begin_build() {
  const FrameDescriptor& frame = registers_.descriptor;
  steps_ = plan_build(config_, frame);
  step_ = 0;
  ++(frame.dynamic_refit != 0 ? refits_ : builds_);
  triangles_ += frame.dynamic_triangle_count;
}

void TreeBuilder::begin_step(Cycle now) {
  const BuildStep& step = steps_[step_];
  issued_.assign(step.streams.size(), 0);
  left_ = 0;
  for (const BuildStream& stream : step.streams) left_ += stream.lines;
  began_at_ = now;
  computed_at_ = now + step.compute;
}

/// The next line of that of the step's streams which is furthest behind, if there is room for it.
bool TreeBuilder::issue() {
  if (left_ == 0 || outstanding_ == config_.outstanding || !memory_->request.can_push()) return false;
  const std::vector<BuildStream>& streams = steps_[step_].streams;
  std::size_t last = 0;
  for (std::size_t i = 1; i < streams.size(); ++i) {
    if (issued_[i] * streams[last].lines < issued_[last] * streams[i].lines) last = i;
  }
  const BuildStream& stream = streams[last];
  memory_->request.push({stream.base + issued_[last] * line_bytes, stream.write ? ~std::uint64_t{0} : 0, 0, 0});
  ++issued_[last];
  --left_;
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
  if (step_ == steps_.size()) {
    if (!build_->can_pop()) return {moved ? State::busy : State::stall_in, moved ? now + 1 : never};
    build_->pop();
    begin_build();
    begin_step(now);
    moved = true;
  } else if (left_ == 0 && outstanding_ == 0 && now >= computed_at_ &&
             (step_ + 1 < steps_.size() || built_->can_push())) {
    stage_cycles_[static_cast<std::size_t>(steps_[step_].stage)] += now - began_at_;
    moved = true;
    if (++step_ < steps_.size()) {
      begin_step(now);
    } else {
      built_->push({});
    }
  }
  if (issue()) moved = true;
  if (moved) return {State::busy, now + 1};
  if (now < computed_at_) return {State::busy, computed_at_};
  return {left_ == 0 && outstanding_ == 0 ? State::stall_out : State::stall_mem};
}

void TreeBuilder::report(Statistics& out) const {
  out.push_back({path(), "builds", builds_, "", "trees built"});
  out.push_back({path(), "refits", refits_, "", "trees of which only the boxes were made anew"});
  out.push_back({path(), "triangles", triangles_, "", "triangles in them"});
  out.push_back({path(), "lines_read", lines_read_, "lines", "read from memory"});
  out.push_back({path(), "lines_written", lines_written_, "lines", "written to memory"});
  static constexpr std::array<const char*, build_stages> texts{
      "stage: triangles are read for the first time",
      "stage, sah: levels that do not fit on chip are split",
      "stage, sah: the rest is split; nodes and triangles are written",
      "stage, morton: codes are made",
      "stage, morton: codes are sorted",
      "stage, morton: nodes are emitted",
      "stage, morton and refit: boxes are made; nodes and triangles are written",
      "stage: attributes are brought into the triangles' order"};
  for (std::size_t i = 0; i < build_stages; ++i) {
    out.push_back({path(), stage_counters[i], stage_cycles_[i], "cycles", texts[i]});
  }
}

std::string TreeBuilder::describe() const {
  return "step " + std::to_string(step_) + " of " + std::to_string(steps_.size()) + ", " +
         std::to_string(outstanding_) + " requests outstanding";
}

}  // namespace artu::hw
