#include "hw/memory/build_plan.h"

#include <algorithm>

#include "hw/fabric/memory_port.h"

namespace artu::hw {

namespace {

constexpr std::uint64_t reference_bytes = 16, skeleton_bytes = 8;

std::uint64_t lines_for(std::uint64_t bytes) { return (bytes + line_bytes - 1) / line_bytes; }

/// The part of `total` that falls to the i-th of `count` equal shares.
std::uint64_t share(std::uint64_t total, std::uint64_t i, std::uint64_t count) {
  return total * (i + 1) / count - total * i / count;
}

class Planner {
 public:
  Planner(const TreeBuilderConfig& config, const FrameDescriptor& frame)
      : config_(config),
        frame_(frame),
        n_(frame.dynamic_triangle_count),
        streamed_(n_ > config.triangles_per_pass),
        scratch_{frame.build_scratch, frame.build_scratch + area()} {}

  std::vector<BuildStep> plan() {
    if (frame_.dynamic_refit != 0) {
      refit();
    } else if (config_.algorithm == BuildAlgorithm::morton) {
      morton();
    } else {
      sah();
    }
    add(BuildStage::attributes,
        {{frame_.build_input + n_ * line_bytes, n_, false}, {frame_.dynamic_attributes, n_, true}}, records(n_));
    return std::move(steps_);
  }

 private:
  void sah() {
    const BuildWork& work = frame_.build;
    add(BuildStage::read, {input(), scratch(0, n_ * reference_bytes, true)}, records(n_));
    const std::uint64_t levels = work.upper_levels;
    const std::uint64_t written = work.upper_references - (levels == 0 ? 0 : n_) + work.lower_references;
    for (std::uint64_t i = 0; i < levels; ++i) {
      const std::uint64_t references = share(work.upper_references, i, levels);
      add(BuildStage::levels,
          {scratch(i, references * reference_bytes, false),
           scratch(i + 1, share(written, i, levels) * reference_bytes, true)},
          split(references, share(work.upper_splits, i, levels)));
    }
    add(BuildStage::subtrees,
        {scratch(levels, work.lower_references * reference_bytes, false), input(), nodes(true), triangles()},
        split(work.references - work.upper_references, work.splits - work.upper_splits));
  }

  void morton() {
    const std::uint64_t key_bytes = config_.code_bits <= 10 ? 8 : 12;
    if (!config_.known_box) add(BuildStage::read, {input()}, records(n_));
    add(BuildStage::codes, {input(), scratch(0, n_ * key_bytes, true)}, records(n_));
    const std::uint64_t passes = (3 * config_.code_bits + config_.digit_bits - 1) / config_.digit_bits;
    for (std::uint64_t i = 0; i < passes; ++i) {
      add(BuildStage::sort, {scratch(i, n_ * key_bytes, false), scratch(i + 1, n_ * key_bytes, true)},
          records(n_ + (std::uint64_t{1} << config_.digit_bits)));
    }
    const std::uint64_t skeleton = (n_ - 1) * skeleton_bytes;
    add(BuildStage::hierarchy, {scratch(passes, n_ * key_bytes, false), scratch(passes + 1, skeleton, true)},
        (n_ - 1) * config_.cycles_per_node);
    add(BuildStage::bounds, {scratch(passes + 1, skeleton, false), input(), nodes(true), triangles()},
        2 * (n_ - 1) * config_.cycles_per_box);
  }

  void refit() {
    const std::uint64_t count = frame_.dynamic_node_lines * line_bytes / node_bytes(frame_.dynamic_kind);
    add(BuildStage::bounds, {nodes(false), input(), nodes(true), triangles()}, (n_ + count) * config_.cycles_per_box);
  }

  std::uint64_t records(std::uint64_t count) const { return count * config_.cycles_per_record; }
  std::uint64_t split(std::uint64_t references, std::uint64_t splits) const {
    return (references * config_.cycles_per_triangle + config_.binning_units - 1) / config_.binning_units +
           splits * config_.bins * config_.cycles_per_bin;
  }

  /// Bytes of one of the two areas of the scratch memory.
  std::uint64_t area() const { return lines_for(frame_.dynamic_reference_count * reference_bytes) * line_bytes; }
  /// What one step writes into an area, the next one reads while it writes into the other.
  BuildStream scratch(std::uint64_t area, std::uint64_t bytes, bool write) const {
    return {scratch_[area % 2], streamed_ ? lines_for(bytes) : 0, write};
  }
  BuildStream input() const { return {frame_.build_input, n_, false}; }
  BuildStream nodes(bool write) const { return {frame_.dynamic_nodes, frame_.dynamic_node_lines, write}; }
  BuildStream triangles() const { return {frame_.dynamic_triangles, frame_.dynamic_reference_count, true}; }

  void add(BuildStage stage, std::vector<BuildStream> streams, std::uint64_t compute) {
    streams.erase(std::remove_if(streams.begin(), streams.end(), [](const BuildStream& s) { return s.lines == 0; }),
                  streams.end());
    if (!streams.empty() || compute != 0) steps_.push_back({stage, std::move(streams), compute});
  }

  const TreeBuilderConfig& config_;
  const FrameDescriptor& frame_;
  const std::uint64_t n_;
  const bool streamed_;
  const Address scratch_[2];
  std::vector<BuildStep> steps_;
};

}  // namespace

std::vector<BuildStep> plan_build(const TreeBuilderConfig& config, const FrameDescriptor& frame) {
  return Planner(config, frame).plan();
}

}  // namespace artu::hw
