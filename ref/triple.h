// Three numbers of any format: colours and what else shading computes (docs/arithmetic.md section 7), and the points
// and directions of binary64.
#pragma once

#include "ref/number.h"
#include "ref/vec.h"

namespace artu::ref {

/// As Vec3 in vec.h, whose operations these are, for a number type.
template <class N>
struct Triple {
  N x{}, y{}, z{};

  Triple() = default;
  Triple(N x_in, N y_in, N z_in) : x(x_in), y(y_in), z(z_in) {}
  Triple(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}  // implicit: the rounding of an operand
  explicit operator Vec3() const { return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}; }

  friend Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Triple operator-(const Triple& a) { return {-a.x, -a.y, -a.z}; }
  friend Triple operator*(const Triple& a, const Triple& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend Triple operator*(const Triple& a, N s) { return {a.x * s, a.y * s, a.z * s}; }
  friend N dot(const Triple& a, const Triple& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
  friend Triple unit(const Triple& v) {
    using std::sqrt;
    const N l = dot(v, v);
    if (!(N(0x1p-100f) <= l && l <= N(0x1p100f))) return {};
    return v * (N(1) / sqrt(l));
  }
  friend N largest(const Triple& v) { return max(max(v.x, v.y), v.z); }
  friend N largest_magnitude(const Triple& v) {
    using std::fabs;
    return largest(Triple(fabs(v.x), fabs(v.y), fabs(v.z)));
  }
  friend bool is_zero(const Triple& v) { return v.x == N(0) && v.y == N(0) && v.z == N(0); }
  friend bool any_positive(const Triple& v) { return v.x > N(0) || v.y > N(0) || v.z > N(0); }
};

/// What rays and points are made of where they are computed in F: the traces' own vectors in binary32.
template <class F>
struct Space {
  using Vector = Triple<F>;
  struct Uv {
    F x{}, y{};
  };
};
template <>
struct Space<float> {
  using Vector = Vec3;
  using Uv = Vec2;
};
template <class F>
using Vector = typename Space<F>::Vector;
template <class F>
using Uv = typename Space<F>::Uv;

}  // namespace artu::ref
