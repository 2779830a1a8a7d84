// The children of a node that a ray meets, four boxes at a time: the box test of docs/arithmetic.md section 3 in
// binary32 with SSE2, operation for operation, so that every bit is the one of hw/datapath/node_visit.h.
//
// minps and maxps are the contract's minimum and maximum: on a tie, or with a NaN, the second operand.  Not for a ray
// with a limited axis, whose slabs have a rule of their own.  ARTU_PORTABLE leaves it out.
#pragma once

#if defined(__SSE2__) && !defined(ARTU_PORTABLE)
#define ARTU_SSE2 1
#include <emmintrin.h>

#include "hw/datapath/node_visit.h"

namespace artu::hw {

class WideSteps {
 public:
  WideSteps(const Ray& ray, float padding)
      : origin_{_mm_set1_ps(ray.origin.x), _mm_set1_ps(ray.origin.y), _mm_set1_ps(ray.origin.z)},
        inverse_{_mm_set1_ps(ray.inverse.x), _mm_set1_ps(ray.inverse.y), _mm_set1_ps(ray.inverse.z)},
        origin_xyz_(_mm_setr_ps(ray.origin.x, ray.origin.y, ray.origin.z, 1)),
        inverse_xyz_(_mm_setr_ps(ray.inverse.x, ray.inverse.y, ray.inverse.z, 1)),
        padding_(_mm_set1_ps(padding)) {}

  /// Bit i for child i; `enter` of both in lanes 0 and 1.
  unsigned binary(const NodeRecord& node, float limit, __m128& enter) const {
    // Three coordinates of a corner, and in the fourth lane whatever lies behind them.
    const float* lo = &node.lo[0].x;
    const auto distance = [&](std::size_t corner) {
      return _mm_mul_ps(_mm_sub_ps(_mm_loadu_ps(lo + 3 * corner), origin_xyz_), inverse_xyz_);
    };
    const __m128 a0 = distance(0), a1 = distance(1), b0 = distance(2), b1 = distance(3);
    const __m128 near0 = _mm_min_ps(a0, b0), near1 = _mm_min_ps(a1, b1);
    const __m128 far0 = _mm_max_ps(a0, b0), far1 = _mm_max_ps(a1, b1);
    const __m128 near_xy = _mm_unpacklo_ps(near0, near1), near_z = _mm_unpackhi_ps(near0, near1);
    const __m128 far_xy = _mm_unpacklo_ps(far0, far1), far_z = _mm_unpackhi_ps(far0, far1);
    enter = _mm_max_ps(_mm_max_ps(near_xy, _mm_movehl_ps(near_xy, near_xy)), near_z);
    const __m128 exit = _mm_min_ps(_mm_min_ps(far_xy, _mm_movehl_ps(far_xy, far_xy)), far_z);
    return meets(enter, exit, limit) & 3u;
  }

  /// What the node's visit adds to `out`, but for the intervals' ends.
  void binary(const NodeRecord& node, float limit, Steps& out) const {
    out.tests += 2;
    __m128 enters;
    const unsigned met = binary(node, limit, enters);
    alignas(16) float enter[4];
    _mm_store_ps(enter, enters);
    if ((met & 1) != 0) out.add(node.child[0], enter[0], 0);
    if ((met & 2) != 0) out.add(node.child[1], enter[1], 0);
  }

  /// The same of a wide node.
  template <int Width>
  void wide(const WideNodeRecord<Width>& node, float limit, Steps& out) const {
    out.tests += node.count;
    for (int first = 0; first < node.count; first += 4) {
      __m128 enters;
      unsigned met = quarter(node, first, limit, enters);
      if (node.count - first < 4) met &= (1u << (node.count - first)) - 1;
      alignas(16) float enter[4];
      _mm_store_ps(enter, enters);
      for (int i = 0; met != 0; ++i, met >>= 1) {
        if ((met & 1) != 0) out.add(node.child[first + i], enter[i], 0);
      }
    }
  }

 private:
  /// Bit i for child first + i, of four.
  template <int Width>
  unsigned quarter(const WideNodeRecord<Width>& node, int first, float limit, __m128& enter) const {
    __m128 near[3], far[3];
    for (int axis = 0; axis < 3; ++axis) {
      const __m128 origin = _mm_set1_ps(node.origin[axis]);
      const __m128 step = _mm_castsi128_ps(_mm_set1_epi32(static_cast<int>(std::uint32_t{node.exponent[axis]} << 23)));
      const __m128 lo = _mm_add_ps(origin, _mm_mul_ps(four(&node.lo[axis][first]), step));
      const __m128 hi = _mm_add_ps(origin, _mm_mul_ps(four(&node.hi[axis][first]), step));
      const __m128 a = _mm_mul_ps(_mm_sub_ps(lo, origin_[axis]), inverse_[axis]);
      const __m128 b = _mm_mul_ps(_mm_sub_ps(hi, origin_[axis]), inverse_[axis]);
      near[axis] = _mm_min_ps(a, b);
      far[axis] = _mm_max_ps(a, b);
    }
    enter = _mm_max_ps(_mm_max_ps(near[0], near[1]), near[2]);
    const __m128 exit = _mm_min_ps(_mm_min_ps(far[0], far[1]), far[2]);
    return meets(enter, exit, limit);
  }

  /// Four bytes as binary32.
  static __m128 four(const std::uint8_t* bytes) {
    int packed;
    std::memcpy(&packed, bytes, sizeof packed);
    const __m128i zero = _mm_setzero_si128();
    return _mm_cvtepi32_ps(_mm_unpacklo_epi16(_mm_unpacklo_epi8(_mm_cvtsi32_si128(packed), zero), zero));
  }
  unsigned meets(__m128 enter, __m128 exit, float limit) const {
    const __m128 begin = _mm_max_ps(enter, _mm_setzero_ps());
    const __m128 end = _mm_min_ps(_mm_mul_ps(exit, padding_), _mm_set1_ps(limit));
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(begin, end)));
  }

  const __m128 origin_[3], inverse_[3];
  const __m128 origin_xyz_, inverse_xyz_;  // and 1, which keeps the lane behind the corners from being subnormal
  const __m128 padding_;
};

}  // namespace artu::hw

#endif
