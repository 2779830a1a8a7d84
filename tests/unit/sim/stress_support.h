// Walkers that are wrong on purpose, over the same image records as the unit's: the product's code has no hooks.
#pragma once

#include <cmath>
#include <limits>

#include "sim/report/names.h"
#include "sim/stress/campaign.h"
#include "sim/stress/meshes.h"
#include "sim/stress/subjects.h"

namespace artu::sim::testing {

/// Which parts of the contract a walker keeps; as constructed all of them.
struct Rules {
  bool clamp = true;                        // section 3, step 5
  bool exact_products = true;               // step 2
  float padding = hw::box_padding();        // of the tree's boxes and planes
  float clamp_padding = hw::box_padding();  // of the triangle's own box
};

inline hw::Interval interval(const hw::Ray& ray, hw::Vector lo, hw::Vector hi, float padding) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  hw::Interval all{-infinity, infinity};
  for (int axis = 0; axis < 3; ++axis) {
    const float o = ray.origin[axis], inverse = ray.inverse[axis];
    const bool limited = std::fabs(inverse) == 0x1p100f;
    const bool inside = lo[axis] <= o && o <= hi[axis];
    if (limited && inside) continue;
    if (limited && ray.direction[axis] == 0) return {infinity, -infinity};
    const float a = (lo[axis] - o) * inverse, b = (hi[axis] - o) * inverse;
    all = {hw::maximum(all.enter, hw::minimum(a, b)), hw::minimum(all.exit, hw::maximum(a, b))};
  }
  return {all.enter, all.exit * padding};
}

inline float determinant(float a, float b, float c, float d, bool exact) {
  if (exact) return static_cast<float>(double(a) * double(b) - double(c) * double(d));
  const float left = a * b, right = c * d;
  return left - right;
}

inline bool intersect(const hw::Ray& ray, const Corners& corners, const Rules& rules, hw::TriangleHit& hit) {
  float x[3], y[3], z[3];
  for (int i = 0; i < 3; ++i) {
    const hw::Vector p = corners[i] - ray.origin;
    x[i] = p[ray.kx] - ray.sx * p[ray.kz];
    y[i] = p[ray.ky] - ray.sy * p[ray.kz];
    z[i] = ray.sz * p[ray.kz];
  }
  const float U = determinant(x[2], y[1], y[2], x[1], rules.exact_products);
  const float V = determinant(x[0], y[2], y[0], x[2], rules.exact_products);
  const float W = determinant(x[1], y[0], y[1], x[0], rules.exact_products);
  if ((U < 0 || V < 0 || W < 0) && (U > 0 || V > 0 || W > 0)) return false;
  const float det = (U + V) + W;
  if (det == 0) return false;
  float t = ((U * z[0] + V * z[1]) + W * z[2]) / det;
  if (t != t) return false;
  if (rules.clamp) {
    const auto lo = [&](float a, float b, float c) { return hw::minimum(hw::minimum(a, b), c); };
    const auto hi = [&](float a, float b, float c) { return hw::maximum(hw::maximum(a, b), c); };
    const auto& [a, b, c] = corners;
    const hw::Interval box = interval(ray, {lo(a.x, b.x, c.x), lo(a.y, b.y, c.y), lo(a.z, b.z, c.z)},
                                      {hi(a.x, b.x, c.x), hi(a.y, b.y, c.y), hi(a.z, b.z, c.z)}, rules.clamp_padding);
    if (box.enter > box.exit) return false;
    t = hw::minimum(hw::maximum(t, box.enter), box.exit);
  }
  if (!(0.0f <= t && t <= ray.tmax)) return false;
  hit = {t, U, V, det};
  return true;
}

/// Every triangle in turn, by `rules`.
class RuledBruteForce : public Subject {
 public:
  RuledBruteForce(const std::vector<Corners>& triangles, Rules rules)
      : Subject("ruled brute"), triangles_(triangles), rules_(rules) {}
  Answer closest(const hw::Ray& ray) const override {
    hw::Found found;
    hw::TriangleHit hit;
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      if (intersect(ray, triangles_[i], rules_, hit)) hw::consider(hit, i, i, false, found);
    }
    return answer_of(found);
  }
  bool occluded(const hw::Ray& ray) const override { return closest(ray).hit; }

 private:
  const std::vector<Corners>& triangles_;
  Rules rules_;
};

/// Walks binary BVHs, depth first without sorting, by `rules`.
class RuledWalker : public Subject {
 public:
  RuledWalker(std::shared_ptr<const LaidDown> laid, Rules rules)
      : Subject("ruled bvh2"), laid_(std::move(laid)), rules_(rules) {}
  Answer closest(const hw::Ray& ray) const override {
    const hw::FrameDescriptor& f = laid_->frame;
    hw::Found found;
    visit(f.static_root, f.static_lo, f.static_hi, ray, found);
    visit(f.dynamic_root, f.dynamic_lo, f.dynamic_hi, ray, found);
    return answer_of(found);
  }
  bool occluded(const hw::Ray& ray) const override { return closest(ray).hit; }

 private:
  void visit(std::uint32_t reference, hw::Vector lo, hw::Vector hi, const hw::Ray& ray, hw::Found& found) const {
    using Reference = hw::NodeReference;
    if (reference == Reference::none) return;
    if (!hw::meets(interval(ray, lo, hi, rules_.padding), found.hit ? found.best.t : ray.tmax)) return;
    const bool dynamic = Reference::is_dynamic(reference);
    const hw::FrameDescriptor& f = laid_->frame;
    if (!Reference::is_leaf(reference)) {
      const auto& node =
          laid_->image.at<hw::NodeRecord>((dynamic ? f.dynamic_nodes : f.static_nodes) +
                                          hw::Address{Reference::index(reference)} * sizeof(hw::NodeRecord));
      visit(node.child[0], node.lo[0], node.hi[0], ray, found);
      visit(node.child[1], node.lo[1], node.hi[1], ray, found);
      return;
    }
    for (std::uint32_t i = 0; i < Reference::count(reference); ++i) {
      const std::uint32_t at = Reference::first(reference) + i;
      const auto& record = laid_->image.at<hw::TriangleRecord>((dynamic ? f.dynamic_triangles : f.static_triangles) +
                                                               hw::Address{at} * sizeof(hw::TriangleRecord));
      hw::TriangleHit hit;
      if (intersect(ray, {record.a, record.b, record.c}, rules_, hit)) {
        hw::consider(hit, record.primitive, at, dynamic, found);
      }
    }
  }

  std::shared_ptr<const LaidDown> laid_;
  Rules rules_;
};

}  // namespace artu::sim::testing
