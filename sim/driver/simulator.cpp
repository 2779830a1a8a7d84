#include "sim/driver/simulator.h"

#include <algorithm>
#include <chrono>

#include "sim/driver/image_builder.h"
#include "traces/error.h"

namespace artu::sim {

namespace {

/// SystemC has one current context; each simulator has its own, so that a process can hold several.
class Context {
 public:
  Context() : own_(new sc_core::sc_simcontext), before_(sc_core::sc_curr_simcontext) { enter(); }
  ~Context() {
    if (sc_core::sc_curr_simcontext == own_) sc_core::sc_curr_simcontext = before_;
  }
  void enter() { sc_core::sc_curr_simcontext = sc_core::sc_default_global_context = own_; }

 private:
  sc_core::sc_simcontext* own_;
  sc_core::sc_simcontext* before_;
};

hw::RunMode mode_of(const SimulationOptions& options) {
  return {options.fidelity == Fidelity::clocked,
          options.shuffle_ticks,
          options.random_stall,
          options.seed,
          options.log,
          options.log_sink};
}

std::uint64_t sum(const hw::Statistics& statistics, const std::string& name) {
  std::uint64_t total = 0;
  for (const hw::Statistic& s : statistics) {
    if (s.name == name) total += s.value;
  }
  return total;
}

}  // namespace

FrameOutcome outcome_of(const traces::Scene& scene, const traces::Frame& frame, hw::FrameResult result) {
  FrameOutcome outcome;
  outcome.index = frame.index;
  outcome.width = scene.width;
  outcome.height = scene.height;
  outcome.cycles = result.cycles;
  outcome.static_triangles = scene.static_geometry.triangle_count();
  outcome.dynamic_triangles = frame.dynamic.triangle_count();
  outcome.rays_primary = sum(result.statistics, "primary_rays");
  outcome.rays_shadow = sum(result.statistics, "shadow_rays");
  outcome.rays_reflection = sum(result.statistics, "reflection_rays");
  outcome.rays_refraction = sum(result.statistics, "refraction_rays");
  outcome.node_visits = sum(result.statistics, "node_visits");
  outcome.triangle_tests = sum(result.statistics, "triangle_tests");
  outcome.dram_read_bytes = sum(result.statistics, "read_bytes");
  outcome.dram_write_bytes = sum(result.statistics, "write_bytes");
  outcome.statistics = std::move(result.statistics);
  outcome.violations = std::move(result.violations);
  return outcome;
}

struct Simulator::Impl {
  Impl(const traces::Scene& scene, const hw::UnitConfig& config, const SimulationOptions& options, FrameFrom frames)
      : scene(scene),
        config(config),
        fidelity(options.fidelity),
        builder(scene, config, std::move(frames), image, options.static_trees),
        unit("unit", config, mode_of(options), image, options.fault) {
    dynamic_cast<hw::Dram&>(unit.dram).observe(options.memory_observer);
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

  void check_stack(const traces::Frame& frame) const {
    const std::uint32_t needed = builder.stack_needed();
    const bool refuse = config.core.stack_overflow == hw::StackOverflow::refuse;
    const std::uint32_t room = refuse ? config.core.stack_entries : hw::maximum_stack;
    if (needed <= room) return;
    throw InputError(
        scene.name + ": frame " + std::to_string(frame.index),
        "the tree needs a stack of " + std::to_string(needed) + " entries; " +
            (refuse ? "core.stack_entries is " : "no more can be spilled or found again than ") + std::to_string(room) +
            (refuse && needed <= hw::maximum_stack ? "; with core.stack_overflow = spill fewer are enough" : ""));
  }

  const traces::Scene& scene;
  const hw::UnitConfig config;
  const Fidelity fidelity;
  hw::MemoryImage image;
  ImageBuilder builder;
  Context context;
  hw::RayTracingUnit unit;
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
  impl.check_stack(frame);

  hw::PixelRecords pixels(std::size_t{impl.scene.width} * impl.scene.height);
  const auto before = std::chrono::steady_clock::now();
  hw::FrameResult result = impl.unit.run(descriptor, &pixels);
  const auto after = std::chrono::steady_clock::now();
  if (result.dead_locked) throw DeadLock("frame " + std::to_string(frame.index) + ": " + result.picture);
  FrameOutcome outcome = outcome_of(impl.scene, frame, std::move(result));
  outcome.fidelity = impl.fidelity;
  outcome.dynamic_tree = impl.builder.dynamic_quality();
  outcome.pixels = std::move(pixels);
  outcome.simulation_seconds = std::chrono::duration<double>(after - before).count();
  return outcome;
}

}  // namespace artu::sim
