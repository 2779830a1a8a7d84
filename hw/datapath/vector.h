// Three-component vectors with the operation order of docs/arithmetic.md section 1.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "hw/datapath/narrow.h"

namespace artu::hw {

/// Of a number type of hw/datapath/narrow.h.
template <class R>
struct VectorOf {
  R x{}, y{}, z{};
  R operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

  friend VectorOf operator+(VectorOf a, VectorOf b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend VectorOf operator-(VectorOf a, VectorOf b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend VectorOf operator-(VectorOf a) { return {-a.x, -a.y, -a.z}; }
  friend VectorOf operator*(VectorOf a, VectorOf b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend VectorOf operator*(VectorOf a, R s) { return {a.x * s, a.y * s, a.z * s}; }
};
using Vector = VectorOf<float>;

inline constexpr float two_pow_100 = 0x1p100f;
inline constexpr float two_pow_minus_100 = 0x1p-100f;

/// The contract's minimum and maximum: on a tie, or with a NaN, the second operand.
template <class R>
R minimum(R a, R b) {
  return a < b ? a : b;
}
template <class R>
R maximum(R a, R b) {
  return a > b ? a : b;
}

template <class R>
R dot(VectorOf<R> a, VectorOf<R> b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
inline bool is_zero(Vector a) { return a.x == 0 && a.y == 0 && a.z == 0; }
template <class R>
R largest(VectorOf<R> a) {
  return maximum(maximum(a.x, a.y), a.z);
}
inline float largest_magnitude(Vector a) { return largest(Vector{std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}); }
template <class R>
bool any_positive(VectorOf<R> a) {
  return a.x > R(0.0f) || a.y > R(0.0f) || a.z > R(0.0f);
}

/// Unit length, or zero where the squared length is outside [2^-100, 2^100].
template <class R>
VectorOf<R> unit(VectorOf<R> v) {
  using std::sqrt;
  const R l = dot(v, v);
  if (!(l >= R(two_pow_minus_100) && l <= R(two_pow_100))) return {};
  const R s = R(1.0f) / sqrt(l);
  return v * s;
}

/// Between the formats: rounds where R is narrower.
template <class R>
VectorOf<R> to(Vector v) {
  return {R(v.x), R(v.y), R(v.z)};
}
template <class R>
Vector from(VectorOf<R> v) {
  return {float(v.x), float(v.y), float(v.z)};
}

inline std::uint32_t bits_of(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline float float_of(std::uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

}  // namespace artu::hw
