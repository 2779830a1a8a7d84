#include "sim/analytic/analytic_simulator.h"

#include <chrono>
#include <cmath>

#include "hw/functional/render.h"
#include "sim/analytic/cycle_model.h"
#include "sim/analytic/estimates.h"
#include "sim/driver/image_builder.h"
#include "sim/driver/stack_check.h"

namespace artu::sim {

struct AnalyticSimulator::Impl {
  Impl(const traces::Scene& scene, const hw::UnitConfig& config, const SimulationOptions& options, FrameFrom frames)
      : scene(scene),
        config(config),
        builder(scene, config, std::move(frames), image, options.static_trees),
        unit(config, image) {}

  const traces::Scene& scene;
  const hw::UnitConfig config;
  hw::MemoryImage image;
  ImageBuilder builder;
  const hw::FunctionalUnit unit;
};

AnalyticSimulator::AnalyticSimulator(const traces::Scene& scene, const hw::UnitConfig& unit,
                                     const SimulationOptions& options, FrameFrom frames)
    : impl_(std::make_unique<Impl>(scene, unit, options, std::move(frames))) {}

AnalyticSimulator::~AnalyticSimulator() = default;

FrameOutcome AnalyticSimulator::run(const traces::Frame& frame) {
  Impl& impl = *impl_;
  const hw::Address at = impl.builder.add(frame);
  check_stack(impl.scene.name, frame.index, impl.builder.stack_needed(), impl.config.core);
  const hw::FrameDescriptor descriptor = impl.image.at<hw::FrameDescriptor>(at);

  hw::PixelRecords pixels(std::size_t{impl.scene.width} * impl.scene.height);
  const auto before = std::chrono::steady_clock::now();
  MemoryModel memory(impl.config);
  FrameLoad load;
  load.descriptor_lines = sizeof(hw::FrameDescriptor) / 64 + descriptor.light_count;
  if (hw::builds(descriptor, impl.config.skip)) {
    load.build = build_time(impl.config, descriptor, memory);
  }
  const MemoryCounts built = memory.counts();
  DemandTap tap(impl.config, descriptor, memory);
  load.all.counts = impl.unit.run(at, impl.builder.stack_needed(), pixels, tap);
  tap.finish();
  load.all.memory = memory.counts();
  load.all.memory -= built;
  load.all.requests = tap.counts();
  const bool selective = load.all.counts.candidates != 0;
  load.first = load.all;
  if (selective) {
    load.first = {tap.first_counts(), tap.first_requests(), tap.first_memory()};
    load.first.memory -= built;
  }
  load.dirty_lines = memory.dirty_lines() * sample_factor;
  load.imbalance = tap.order().imbalance();
  const CycleEstimate estimate = estimate_cycles(impl.config, load);
  const auto after = std::chrono::steady_clock::now();

  FrameOutcome outcome =
      outcome_of(impl.scene, frame, statistics_of(impl.config, load, built, memory.counts(), estimate));
  outcome.fidelity = Fidelity::analytic;
  outcome.cycles = static_cast<std::uint64_t>(std::llround(estimate.total()));
  outcome.estimates = intervals_of(outcome);
  outcome.dynamic_tree = impl.builder.dynamic_quality();
  outcome.pixels = std::move(pixels);
  outcome.simulation_seconds = std::chrono::duration<double>(after - before).count();
  return outcome;
}

}  // namespace artu::sim
