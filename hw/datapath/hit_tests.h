// The box and triangle tests of a unit, in the formats of its configuration.
#pragma once

#include "hw/datapath/node_visit.h"
#include "hw/datapath/triangle.h"

namespace artu::hw {

class HitTests {
 public:
  explicit HitTests(const PrecisionConfig& precision = {});

  /// Fills the set-up fields from origin and direction, which must not be dead.
  void set_up(Ray& ray) const { hw::set_up(ray, box_bits_, triangle_bits_); }

  Interval box(const Ray& ray, Vector lo, Vector hi) const { return box_(ray, lo, hi, padding_); }
  bool triangle(const Ray& ray, Vector a, Vector b, Vector c, TriangleHit& hit) const {
    return triangle_(*this, ray, a, b, c, hit);
  }
  /// See NodeVisit.
  void node(TreeKind kind, const void* record, const Ray& ray, const Step& from, float limit, std::uint32_t fault,
            Steps& out) const {
    node_(kind, record, ray, from, limit, padding_, fault, out);
  }
  /// The first step of a ray: both root boxes.  A root that is `none` is left out.  Without `skip_dynamic` the dynamic
  /// root is entered though its box is missed, after the static one: nothing is hit in there.
  void roots(const FrameDescriptor& frame, const Ray& ray, std::uint32_t fault, Steps& out,
             bool skip_dynamic = true) const;

 private:
  using BoxTest = Interval (*)(const Ray&, Vector lo, Vector hi, float padding);
  using TriangleTest = bool (*)(const HitTests&, const Ray&, Vector a, Vector b, Vector c, TriangleHit&);
  template <class R, class OfBox>
  static bool intersect(const HitTests& tests, const Ray& ray, Vector a, Vector b, Vector c, TriangleHit& hit);
  template <int... I>
  void choose(std::integer_sequence<int, I...>);

  int box_bits_, triangle_bits_;
  float padding_;
  NodeVisit node_;
  BoxTest box_;
  TriangleTest triangle_;
};

}  // namespace artu::hw
