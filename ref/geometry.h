// Both classes of geometry of a frame, as one thing to trace rays against (docs/arithmetic.md section 3).
#pragma once

#include "ref/embree_scene.h"

namespace artu::ref {

/// Both scenes have the same tests.
template <class Tests>
struct GeometryOf {
  using Ray = typename Tests::Ray;
  using Number = typename Tests::Number;

  const EmbreeSceneOf<Tests>& fixed;    // static class: ids from 0
  const EmbreeSceneOf<Tests>& dynamic;  // ids from the static triangle count

  /// A ray for both.
  Ray ray(const Vector<Number>& origin, const Vector<Number>& direction, Number tmax = no_tmax) const {
    return tests().ray(origin, direction, tmax);
  }
  HitIn<Number> closest(const Ray& ray) const {
    HitIn<Number> best;
    fixed.closest(ray, best);
    dynamic.closest(ray, best);
    return best;
  }
  bool occluded(const Ray& ray) const { return fixed.occluded(ray) || dynamic.occluded(ray); }
  const Tests& tests() const { return fixed.tests(); }
  bool is_dynamic(std::int64_t id) const { return id >= dynamic.first_id(); }
};
using Geometry = GeometryOf<HitTests>;

}  // namespace artu::ref
