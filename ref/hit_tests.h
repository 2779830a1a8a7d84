// Ray set-up and the tests of docs/arithmetic.md section 3 in the formats of a configuration.
#pragma once

#include "ref/padding.h"
#include "ref/precision.h"
#include "ref/triangle.h"

namespace artu::ref {

/// Both tests at the widths of a Precision.  Binary32 is inlined; a narrow test calls the box test by a pointer, so
/// that each format is compiled once for either test and not once for each pair.
class HitTests {
 public:
  using Number = float;  // of rays, points and hits
  using Ray = ref::Ray;

  /// Throws std::invalid_argument for a width outside of 7 ... 23.  `emulate` computes 23 bits by way of binary64 as
  /// well, for tests.
  explicit HitTests(const Precision& precision = {}, bool emulate = false);

  /// `make_ray`, with what the tests read of it in their formats.  All rays for these tests come from here.
  Ray ray(const Vec3& origin, const Vec3& direction, float tmax = no_tmax) const;
  /// The ray's interval in a box, without tmin and tmax.
  Interval interval(const Ray& ray, const Box& box) const { return interval_(ray, box, padding_); }
  /// Whether the ray hits the triangle within [0, ray.tmax]; both sides count.
  bool intersect(const Ray& ray, const Triangle& triangle, TriangleHit& hit) const {
    if (!native_) return narrow_(*this, ray, triangle, hit);
    const auto box = [](const Ray& r, const Box& b) { return box_interval<float>(r, b, interval_padding(widest)); };
    return intersect_in<float>(ray, triangle, box, hit);
  }

  /// True only where `intersect` is false.  Embree's boxes are so wide for narrow tests that most of its candidates are
  /// far from the ray: this tells in binary32, much faster than the test.
  bool surely_misses(const Ray& ray, const Triangle& triangle) const { return !native_ && far_off(ray, triangle); }

  const Precision& precision() const { return precision_; }
  int triangle_bits() const { return precision_.triangle; }

  /// What Embree needs to find every candidate: by how much its boxes are widened, and where it may stop behind a hit
  /// at t (docs/arithmetic.md section 9): a little behind, so that ties are never lost; the narrower the tests, the
  /// more.  The constant makes it positive: Embree compares distances as integers, to which a hit at t = -0 (legal)
  /// lies before everything.
  double padding(const Extent& geometry, const Extent& camera) const {
    return required_padding(geometry, camera, precision_);
  }
  float tfar(float t) const { return t * tfar_factor_ + 0x1p-100f; }

 private:
  template <class N>
  static bool narrow(const HitTests& tests, const Ray& ray, const Triangle& triangle, TriangleHit& hit);

  bool far_off(const Ray& ray, const Triangle& triangle) const;

  bool native_;
  Precision precision_;
  float padding_, margin_, tfar_factor_;
  Interval (*interval_)(const Ray&, const Box&, float padding);
  bool (*narrow_)(const HitTests&, const Ray&, const Triangle&, TriangleHit&);
  float (*to_box_)(float);
  float (*to_triangle_)(float);
};

}  // namespace artu::ref
