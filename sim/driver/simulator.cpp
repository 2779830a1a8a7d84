#include "sim/driver/simulator.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "hw/fabric/simulation_context.h"
#include "hw/watch/request_watch.h"
#include "sim/driver/image_builder.h"
#include "sim/driver/stack_check.h"
#include "traces/error.h"

namespace artu::sim {

namespace {

hw::RunMode mode_of(const SimulationOptions& options) {
  return {options.fidelity == Fidelity::clocked,
          options.shuffle_ticks,
          options.random_stall,
          options.seed,
          options.timeline,
          options.log,
          options.log_sink};
}

}  // namespace

FrameOutcome outcome_of(const traces::Scene& scene, const traces::Frame& frame, hw::FrameResult result) {
  FrameOutcome outcome = outcome_of(scene, frame, std::move(result.statistics));
  outcome.cycles = result.cycles;
  outcome.violations = std::move(result.violations);
  outcome.timeline = std::move(result.timeline);
  return outcome;
}

struct Simulator::Impl {
  Impl(const traces::Scene& scene, const hw::UnitConfig& config, const SimulationOptions& options, FrameFrom frames)
      : scene(scene),
        config(config),
        fidelity(options.fidelity),
        timeline(options.timeline),
        builder(scene, config, std::move(frames), image, options.static_trees),
        unit("unit", config, mode_of(options), image, options.fault) {
    dynamic_cast<hw::Dram&>(unit.dram).observe(options.memory_observer);
    if (!options.watchers.empty() && options.request_sink != nullptr) {
      throw std::logic_error("a unit has one observer: watchers, or a sink of the caches' requests");
    }
    if (!options.watchers.empty()) unit.watch(options.watchers, options.window);
    if (options.request_sink != nullptr) requests = std::make_unique<hw::RequestWatch>(unit, *options.request_sink);
  }

  /// A rule of the log that fits no block is a mistake of whoever wrote it.
  void check_log(const std::vector<hw::LogRule>& rules) const {
    for (const hw::LogRule& rule : rules) {
      bool known = rule.block == "*";
      std::string some;
      for (const std::string& path : unit.block_paths()) {
        known = known || hw::fits(rule, path);
        some += (some.empty() ? "" : ", ") + path;
      }
      if (!known) throw InputError("--log", "no block \"" + rule.block + "\"; there are " + some);
    }
  }

  const traces::Scene& scene;
  const hw::UnitConfig config;
  const Fidelity fidelity;
  const bool timeline;
  hw::MemoryImage image;
  ImageBuilder builder;
  hw::SimulationContext context;
  hw::RayTracingUnit unit;
  std::unique_ptr<hw::RequestWatch> requests;  // where somebody wants to know
};

Simulator::Simulator(const traces::Scene& scene, const hw::UnitConfig& config, const SimulationOptions& options,
                     FrameFrom frames)
    : impl_(std::make_unique<Impl>(scene, config, options, std::move(frames))) {
  impl_->check_log(options.log);
}

Simulator::~Simulator() { impl_->context.enter(); }

FrameOutcome Simulator::run(const traces::Frame& frame) {
  Impl& impl = *impl_;
  impl.context.enter();
  const hw::Address descriptor = impl.builder.add(frame);
  check_stack(impl.scene.name, frame.index, impl.builder.stack_needed(), impl.config.core);

  if (impl.requests) impl.requests->begin_frame();
  hw::PixelRecords pixels(std::size_t{impl.scene.width} * impl.scene.height);
  const auto before = std::chrono::steady_clock::now();
  hw::FrameResult result = impl.unit.run(descriptor, &pixels);
  const auto after = std::chrono::steady_clock::now();
  if (result.dead_locked) throw DeadLock("frame " + std::to_string(frame.index) + ": " + result.picture);
  FrameOutcome outcome = outcome_of(impl.scene, frame, std::move(result));
  outcome.fidelity = impl.fidelity;
  outcome.dynamic_tree = impl.builder.dynamic_quality();
  outcome.pixels = std::move(pixels);
  if (impl.timeline) {
    outcome.visits =
        count_visits(impl.config, impl.image, descriptor, impl.builder.stack_needed(), outcome.pixels.size());
  }
  outcome.simulation_seconds = std::chrono::duration<double>(after - before).count();
  return outcome;
}

}  // namespace artu::sim
