#include "hw/datapath/hit_tests.h"

namespace artu::hw {

/// OfBox is the box test's format where it is known here, else void: then it is called by its pointer.
template <class R, class OfBox>
bool HitTests::intersect(const HitTests& tests, const Ray& ray, Vector a, Vector b, Vector c, TriangleHit& hit) {
  const auto box = [&tests](const Ray& r, Vector lo, Vector hi) {
    if constexpr (std::is_void_v<OfBox>) {
      return tests.box(r, lo, hi);
    } else {
      return box_interval<OfBox>(r, lo, hi, tests.padding_);
    }
  };
  return hw::intersect<R>(ray, a, b, c, box, hit);
}

template <int... I>
void HitTests::choose(std::integer_sequence<int, I...>) {
  static constexpr BoxTest boxes[] = {&box_interval<Real<fewest_fraction_bits + I>>...};
  static constexpr TriangleTest triangles[] = {&intersect<Real<fewest_fraction_bits + I>, void>...};
  box_ = boxes[box_bits_ - fewest_fraction_bits];
  triangle_ = triangles[triangle_bits_ - fewest_fraction_bits];
}

HitTests::HitTests(const PrecisionConfig& precision)
    : box_bits_(static_cast<int>(precision.box)),
      triangle_bits_(static_cast<int>(precision.triangle)),
      padding_(box_padding(box_bits_ < triangle_bits_ ? box_bits_ : triangle_bits_)),
      node_(node_visit(box_bits_)) {
  choose(EveryWidth());
  if (box_bits_ == most_fraction_bits && triangle_bits_ == most_fraction_bits) triangle_ = &intersect<float, float>;
}

void HitTests::roots(const FrameDescriptor& frame, const Ray& ray, std::uint32_t fault, Steps& out,
                     bool skip_dynamic) const {
  // A step's interval is the one in which the walk goes on: cut to [0, tmax], which a kd-tree splits further.
  const auto root = [&](std::uint32_t reference, Vector lo, Vector hi) {
    if (reference == NodeReference::none) return false;
    Interval whole = box(ray, lo, hi);
    if (fault != 0) whole.exit = float_of(bits_of(whole.exit) ^ fault);
    ++out.tests;
    if (!meets(whole, ray.tmax)) return true;
    out.add(reference, maximum(whole.enter, 0.0f), minimum(whole.exit, ray.tmax));
    return false;
  };
  root(frame.static_root, frame.static_lo, frame.static_hi);
  const bool missed = root(frame.dynamic_root, frame.dynamic_lo, frame.dynamic_hi);
  if (missed && !skip_dynamic) out.add(frame.dynamic_root, out.count != 0 ? out.step[0].enter : 0.0f, ray.tmax);
}

}  // namespace artu::hw
