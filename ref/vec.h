// Binary32 scalars and vectors of the arithmetic contract (docs/arithmetic.md section 1).
//
// Each function is the contract's expression in the contract's order; std::min, std::max and std::fmin differ
// from it on ties and NaN, so none of them is used in ref/.
#pragma once

#include <cmath>

#include "traces/frame.h"

namespace artu::ref {

using traces::Vec2;
using traces::Vec3;

inline float min(float a, float b) { return a < b ? a : b; }
inline float max(float a, float b) { return a > b ? a : b; }
inline double min(double a, double b) { return a < b ? a : b; }  // of binary64.h; the contract has only float's
inline double max(double a, double b) { return a > b ? a : b; }

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(const Vec3& a, const Vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Vec3 operator*(const Vec3& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }

inline float dot(const Vec3& a, const Vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

/// (0, 0, 0) where the length is out of range or NaN, so the result is never a NaN.
inline Vec3 unit(const Vec3& v) {
  const float l = dot(v, v);
  if (!(0x1p-100f <= l && l <= 0x1p100f)) return {};
  const float s = 1.0f / std::sqrt(l);
  return v * s;
}

inline float largest(const Vec3& v) { return max(max(v.x, v.y), v.z); }
inline float largest_magnitude(const Vec3& v) { return largest({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
inline bool any_positive(const Vec3& v) { return v.x > 0 || v.y > 0 || v.z > 0; }
inline bool is_zero(const Vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

}  // namespace artu::ref
