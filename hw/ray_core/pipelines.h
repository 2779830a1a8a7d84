// Pipeline depths of the datapaths, from the latencies of their operators: the longest chain of each.
#pragma once

#include "hw/unit_config.h"

namespace artu::hw {

struct Pipelines {
  explicit Pipelines(const OperatorConfig& o)
      : box(o.add + o.multiply + 3 * o.compare + o.multiply + 2 * o.compare),
        wide_box(o.multiply + o.add + box + 2 * o.compare),
        plane(o.add + 2 * o.multiply + 2 * o.compare),
        triangle(o.add + (o.multiply + o.add) + (o.multiply + o.add) + 2 * o.add + o.divide + 3 * o.compare),
        set_up(o.divide + 2 * o.compare),
        unit_vector(o.multiply + 2 * o.add + o.square_root + o.divide + o.multiply),
        generate(o.multiply + 2 * o.add + unit_vector),
        // Barycentrics, attributes, then the normals' unit vectors; the offset origin last.
        hit_point(o.divide + 2 * o.add + o.multiply + 2 * o.add + unit_vector + o.multiply + o.add),
        texture(3 * o.add + 2 * o.multiply),
        // Direction and distance, half vector, ten squarings at most, weights.
        light(o.add + unit_vector + o.add + unit_vector + 10 * o.multiply + 3 * o.multiply),
        next_ray(2 * o.multiply + o.add + o.square_root + 2 * o.multiply + o.add + unit_vector),
        accumulate(o.multiply + o.add) {}

  /// From a node's data to the ray's next step.
  std::uint32_t node(TreeKind kind) const {
    return kind == TreeKind::kd ? plane : kind == TreeKind::bvh2 ? box : wide_box;
  }

  std::uint32_t box;       // two boxes, nearer first
  std::uint32_t wide_box;  // decoding, and sorting up to eight
  std::uint32_t plane;     // of a kd-tree
  std::uint32_t triangle, set_up, unit_vector, generate, hit_point, texture, light, next_ray, accumulate;
};

}  // namespace artu::hw
