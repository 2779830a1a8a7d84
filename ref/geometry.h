// Both classes of geometry of a frame, as one thing to trace rays against (docs/arithmetic.md section 3).
#pragma once

#include "ref/embree_scene.h"

namespace artu::ref {

/// Both scenes have the same tests.
struct Geometry {
  const EmbreeScene& fixed;    // static class: ids from 0
  const EmbreeScene& dynamic;  // ids from the static triangle count

  /// A ray for both.
  Ray ray(const Vec3& origin, const Vec3& direction, float tmax = no_tmax) const {
    return fixed.tests().ray(origin, direction, tmax);
  }
  Hit closest(const Ray& ray) const {
    Hit best;
    fixed.closest(ray, best);
    dynamic.closest(ray, best);
    return best;
  }
  bool occluded(const Ray& ray) const { return fixed.occluded(ray) || dynamic.occluded(ray); }
  bool is_dynamic(std::int64_t id) const { return id >= dynamic.first_id(); }
};

}  // namespace artu::ref
