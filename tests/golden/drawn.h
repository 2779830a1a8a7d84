// Configurations drawn at random, the same ones everywhere: all trees, policies, orders, stacks and memories.
#pragma once

#include <algorithm>

#include "hw/selective/policy.h"
#include "hw/unit_config.h"

namespace artu::golden_tests {

/// A number below `count`.
class Draw {
 public:
  explicit Draw(std::uint32_t seed = 12345) : state_(seed) {}
  std::uint32_t operator()(std::uint32_t count) {
    state_ = state_ * 1664525u + 1013904223u;
    return (state_ >> 16) % count;
  }

 private:
  std::uint32_t state_;
};

/// What decides for each pixel, but for the policy and its thresholds.
template <class DrawBelow>
void draw_comparison(hw::SelectiveConfig& s, DrawBelow& draw) {
  s.stride = 2u << draw(3);
  s.passes = static_cast<hw::Passes>(draw(2));
  s.compare = static_cast<hw::Compare>(draw(2));
  if (s.compare == hw::Compare::reference_count) s.count = static_cast<hw::Count>(draw(2));
  s.reference_count = draw(9);
  s.metric = static_cast<hw::Metric>(draw(3));
  s.magnitude = static_cast<hw::Magnitude>(draw(3));
}

inline hw::UnitConfig draw_configuration(Draw& draw) {
  hw::UnitConfig config;
  config.core.count = 1 + draw(8);
  config.core.contexts = 1 + draw(40);
  config.core.queue_depth = 1 + draw(5);
  config.selective.tile = 4u << draw(4);
  config.selective.stride = std::min(2u << draw(3), config.selective.tile);
  config.selective.passes = static_cast<hw::Passes>(draw(2));
  config.selective.overlap = draw(4) != 0;
  config.selective.metric = static_cast<hw::Metric>(draw(3));
  config.selective.policy = draw(static_cast<std::uint32_t>(hw::policy_names().size()));
  const auto cache = [&draw] {
    return hw::CacheConfig{256u << draw(6), 1u << draw(3), 1 + draw(12), 1 + draw(9), 1 + draw(9)};
  };
  config.core.node_cache = cache();
  config.core.triangle_cache = cache();
  config.core.texture_cache = cache();
  config.selective.pixel_cache = cache();
  config.memory.l2 = cache();
  config.memory.l2_banks = 1u << draw(5);
  while (std::uint64_t{config.memory.l2_banks} * config.memory.l2.ways * 64 > config.memory.l2.size) {
    config.memory.l2_banks /= 2;
  }
  config.memory.write_combining = 2 + draw(20);
  config.core.ray_order = static_cast<hw::RayOrder>(draw(3));
  config.core.pixel_order = static_cast<hw::PixelOrder>(draw(2));
  config.core.dispatch = static_cast<hw::Dispatch>(draw(2));
  config.core.box_testers = 1 + draw(8);
  config.core.node_interval = 1 + draw(4);
  config.core.triangle_interval = 1 + draw(4);
  config.core.stack_overflow = static_cast<hw::StackOverflow>(draw(3));
  config.core.stack_entries = config.core.stack_overflow == hw::StackOverflow::refuse  ? 64
                              : config.core.stack_overflow == hw::StackOverflow::spill ? 8 + draw(4)
                                                                                       : 1 + draw(4);
  config.accel.static_kind = static_cast<hw::TreeKind>(draw(4));
  config.accel.dynamic_kind = static_cast<hw::TreeKind>(draw(4));
  config.accel.leaf_size = 1 + draw(16);
  config.tree_builder.overlap = draw(2) != 0;
  if (config.accel.dynamic_kind != hw::TreeKind::kd) {
    config.tree_builder.algorithm = static_cast<hw::BuildAlgorithm>(draw(2));
  }
  config.memory.interconnect_latency = 1 + draw(9);
  config.memory.dram.clock_mhz = 200 + 137 * draw(10);
  config.memory.dram.channels = 1u << draw(4);
  config.memory.dram.queue_depth = 1 + draw(20);
  config.tree_builder.outstanding = 1 + draw(12);
  for (bool* skip : {&config.skip.dynamic_root, &config.skip.rebuild, &config.skip.shadow, &config.skip.texture,
                     &config.skip.any_hit}) {
    *skip = draw(3) != 0;
  }
  return config;
}

}  // namespace artu::golden_tests
