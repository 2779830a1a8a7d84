#include "sim/driver/functional_simulator.h"

#include <chrono>

#include "hw/functional/functional_unit.h"
#include "sim/driver/image_builder.h"
#include "sim/driver/stack_check.h"

namespace artu::sim {

struct FunctionalSimulator::Impl {
  Impl(const traces::Scene& scene, const hw::UnitConfig& config, const SimulationOptions& options, FrameFrom frames,
       bool portable)
      : scene(scene),
        config(config),
        builder(scene, config, std::move(frames), image, options.static_trees),
        unit(config, image, portable) {}

  const traces::Scene& scene;
  const hw::UnitConfig config;
  hw::MemoryImage image;
  ImageBuilder builder;
  const hw::FunctionalUnit unit;
};

FunctionalSimulator::FunctionalSimulator(const traces::Scene& scene, const hw::UnitConfig& unit,
                                         const SimulationOptions& options, FrameFrom frames, bool portable)
    : impl_(std::make_unique<Impl>(scene, unit, options, std::move(frames), portable)) {}

FunctionalSimulator::~FunctionalSimulator() = default;

FrameOutcome FunctionalSimulator::run(const traces::Frame& frame) {
  Impl& impl = *impl_;
  const hw::Address descriptor = impl.builder.add(frame);
  check_stack(impl.scene.name, frame.index, impl.builder.stack_needed(), impl.config.core);

  hw::PixelRecords pixels(std::size_t{impl.scene.width} * impl.scene.height);
  const auto before = std::chrono::steady_clock::now();
  const hw::FunctionalCounts counts = impl.unit.run(descriptor, impl.builder.stack_needed(), pixels);
  const auto after = std::chrono::steady_clock::now();
  hw::Statistics statistics;
  counts.report(statistics);
  FrameOutcome outcome = outcome_of(impl.scene, frame, std::move(statistics));
  outcome.fidelity = Fidelity::functional;
  outcome.dynamic_tree = impl.builder.dynamic_quality();
  outcome.pixels = std::move(pixels);
  outcome.simulation_seconds = std::chrono::duration<double>(after - before).count();
  return outcome;
}

}  // namespace artu::sim
