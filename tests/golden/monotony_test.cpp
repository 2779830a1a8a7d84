// More of a resource, or a shorter latency, never costs cycles by more than a percent, where theory says that it
// cannot.
//
// It does not say so where more rays share a cache: more cores, contexts or outstanding misses change which lines are
// evicted and which rows are open.  docs/validation.md has how large that is on a real scene.
#include <functional>

#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

using Setter = std::function<void(hw::UnitConfig&, std::uint32_t)>;

struct Sweep {
  const char* name;
  Setter set;
  std::vector<std::uint32_t> values;  // each at least as good as the one before
};

std::vector<Sweep> sweeps() {
  using C = hw::UnitConfig;
  using N = std::uint32_t;
  return {
      {"core.queue_depth", [](C& c, N v) { c.core.queue_depth = v; }, {1, 2, 4, 8, 32}},
      {"core.box_testers", [](C& c, N v) { c.core.box_testers = v; }, {1, 2, 4, 8}},
      {"core.node_interval", [](C& c, N v) { c.core.node_interval = v; }, {16, 8, 4, 2, 1}},
      {"core.triangle_interval", [](C& c, N v) { c.core.triangle_interval = v; }, {16, 8, 4, 2, 1}},
      {"core.node_cache.size", [](C& c, N v) { c.core.node_cache.size = v; }, {1024, 4096, 16384, 65536, 262144}},
      {"core.triangle_cache.size",
       [](C& c, N v) { c.core.triangle_cache.size = v; },
       {1024, 4096, 16384, 65536, 262144}},
      {"core.node_cache.mshrs", [](C& c, N v) { c.core.node_cache.mshrs = v; }, {1, 2, 4, 8}},
      {"core.node_cache.hit_latency", [](C& c, N v) { c.core.node_cache.hit_latency = v; }, {40, 10, 4, 2, 1}},
      {"memory.l2.size", [](C& c, N v) { c.memory.l2.size = v; }, {8192, 32768, 131072, 524288}},
      {"memory.l2.hit_latency", [](C& c, N v) { c.memory.l2.hit_latency = v; }, {80, 40, 20, 10, 5}},
      {"memory.l2.mshrs", [](C& c, N v) { c.memory.l2.mshrs = v; }, {4, 8, 16, 32}},
      {"memory.l2_banks", [](C& c, N v) { c.memory.l2_banks = v; }, {1, 2, 4}},
      {"memory.interconnect_latency", [](C& c, N v) { c.memory.interconnect_latency = v; }, {64, 16, 4, 1}},
      {"memory.dram.channels", [](C& c, N v) { c.memory.dram.channels = v; }, {1, 2, 4, 8}},
      {"memory.dram.queue_depth", [](C& c, N v) { c.memory.dram.queue_depth = v; }, {2, 4, 8, 16, 32, 64}},
      {"memory.dram.preset",
       [](C& c, N v) { hw::apply(static_cast<hw::DramPreset>(v), c.memory.dram); },
       {static_cast<N>(hw::DramPreset::lpddr4_3200), static_cast<N>(hw::DramPreset::lpddr4x_4266),
        static_cast<N>(hw::DramPreset::lpddr5_6400)}},
      {"operators.divide", [](C& c, N v) { c.operators.divide = v; }, {64, 40, 12, 6, 1}},
      {"operators.add", [](C& c, N v) { c.operators.add = v; }, {16, 8, 3, 1}},
      {"tree_builder.binning_units", [](C& c, N v) { c.tree_builder.binning_units = v; }, {1, 2, 4}},
      {"core.count, up to what the memory feeds", [](C& c, N v) { c.core.count = v; }, {1, 2, 3, 4}},
      {"core.contexts, up to what the caches hold", [](C& c, N v) { c.core.contexts = v; }, {1, 2, 4, 8, 16}},
  };
}

TEST(Monotony, MoreOfAResourceNeverCostsMoreThanAPercent) {
  for (const bool selective : {false, true}) {
    Recipe recipe;
    recipe.width = 96;
    recipe.height = 64;
    recipe.subdivisions = 5;
    recipe.mirror = true;
    const TestScene scene = make_scene(recipe);
    for (const Sweep& sweep : sweeps()) {
      std::uint64_t before = 0;
      for (const std::uint32_t value : sweep.values) {
        hw::UnitConfig config;
        config.selective.enabled = selective;
        sweep.set(config, value);
        sim::Simulator simulator(scene.scene, config, {});
        const std::uint64_t cycles = simulator.run(scene.frames[0]).cycles;
        if (before != 0) {
          EXPECT_LE(100 * cycles, 101 * before) << sweep.name << " = " << value << ", selective " << selective;
        }
        before = cycles;
      }
    }
  }
}

}  // namespace
}  // namespace artu::golden_tests
