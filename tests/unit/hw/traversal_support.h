// Traversal and intersection with node and triangle memories that always hit.
#pragma once

#include <gtest/gtest.h>

#include "hw/ray_core/intersection.h"
#include "unit/hw/core_support.h"

namespace artu::hw::test {

inline constexpr Cycle hit_latency = 2;     // of the caches, which always hit here
inline constexpr Cycle spill_latency = 20;  // of the memory that stacks are spilled to
inline constexpr auto leaf = NodeReference::leaf;
inline constexpr auto inner = NodeReference::inner;

inline constexpr RayCoreConfig core_config{};

struct Walker {
  explicit Walker(std::size_t contexts = 64, const RayCoreConfig& config = core_config)
      : scene(contexts),
        traversal(
            bench.block<Traversal>("traversal", scene.registers, scene.image, scene.contexts, config, scene.pipelines)),
        intersection(bench.block<Intersection>("intersection", scene.registers, scene.image, scene.contexts,
                                               PrecisionConfig{}, config.triangle_interval)),
        tested(bench.fifo<Slot>("tested", static_cast<std::uint32_t>(contexts), scene.pipelines.triangle)),
        node_memory(bench.block<ScriptedMemory>("node_memory", nodes, hit_latency, hit_latency)),
        triangle_memory(bench.block<ScriptedMemory>("triangle_memory", triangles, hit_latency, hit_latency)),
        spill_memory(bench.block<ScriptedMemory>("spill_memory", spills, 1, spill_latency)),
        rays(bench.block<Source<Slot>>("rays", primary)),
        no_rays(bench.block<Source<Slot>>("no_rays", others)),
        hits(bench.block<Sink<Slot>>("hits", hit)),
        misses(bench.block<Sink<Slot>>("misses", miss)),
        shadows(bench.block<Sink<Slot>>("shadows", shadow)),
        builder(bench.block<Source<TreeBuilt>>("builder", built)) {
    primary.bind(rays, traversal);
    others.bind(no_rays, traversal);
    leaves.bind(traversal, intersection);
    tested.bind(intersection, traversal);
    hit.bind(traversal, hits);
    miss.bind(traversal, misses);
    shadow.bind(traversal, shadows);
    nodes.bind(traversal, node_memory);
    triangles.bind(intersection, triangle_memory);
    spills.bind(traversal, spill_memory);
    built.bind(builder, traversal);
    traversal.bind({&primary, &others, &tested, &leaves, &hit, &miss, &shadow, &nodes, &spills, &built});
    intersection.bind(leaves, tested, triangles);
  }
  /// Rays 0 ... count - 1 arrive from cycle 10 on.
  void run(std::size_t count, Cycle last = 20000) {
    rays.push_all(9, slots(count));
    bench.run(last);
  }
  Bench bench;
  CoreScene scene;
  Fifo<Slot>& primary = bench.fifo<Slot>("primary", 8);
  Fifo<Slot>& others = bench.fifo<Slot>("others", 8);
  Fifo<Slot>& hit = bench.fifo<Slot>("hit", 5);
  Fifo<Slot>& miss = bench.fifo<Slot>("miss", 5);
  Fifo<Slot>& shadow = bench.fifo<Slot>("shadow", 5);
  Fifo<LeafTask>& leaves = bench.fifo<LeafTask>("leaves", 5);
  MemoryLink& nodes = bench.link("nodes", 4, 1, hit_latency);
  Fifo<TreeBuilt>& built = bench.fifo<TreeBuilt>("built", 2);
  MemoryLink& spills = bench.link("spills", 6, 1, 1);
  MemoryLink& triangles = bench.link("triangles", 4, 1, hit_latency);
  Traversal& traversal;
  Intersection& intersection;
  Fifo<Slot>& tested;
  ScriptedMemory &node_memory, &triangle_memory, &spill_memory;
  Source<Slot>&rays, &no_rays;
  Sink<Slot>&hits, &misses, &shadows;
  Source<TreeBuilt>& builder;
};

/// One node, a leaf on the left and one on the right.
inline void two_leaves(CoreScene& scene) {
  scene.triangle(false, 0, 1, 100);
  scene.triangle(false, 1, 1, 101, 50);
  scene.node(false, 0, {leaf(0, 1, false), 1, 1}, {leaf(1, 1, false), 1, 1, 50});
  scene.root(false, inner(0, false));
}

/// A ray, 3 before it a triangle of the static tree, and `dynamic_z` before it one of the dynamic tree.
inline void a_triangle_in_each_tree(CoreScene& scene, float dynamic_z) {
  scene.triangle(false, 0, 3, 7);
  scene.triangle(true, 0, dynamic_z, 8);
  scene.root(false, leaf(0, 1, false));
  scene.root(true, leaf(0, 1, true));
  scene.ray(0, 1, 1);
}

}  // namespace artu::hw::test
