// Three-component binary32 vectors with the operation order of docs/arithmetic.md section 1.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace artu::hw {

struct Vector {
  float x = 0, y = 0, z = 0;
  float operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline constexpr float two_pow_100 = 0x1p100f;
inline constexpr float two_pow_minus_100 = 0x1p-100f;

/// The contract's minimum and maximum: on a tie, or with a NaN, the second operand.
inline float minimum(float a, float b) { return a < b ? a : b; }
inline float maximum(float a, float b) { return a > b ? a : b; }

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator-(Vector a) { return {-a.x, -a.y, -a.z}; }
inline Vector operator*(Vector a, Vector b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Vector operator*(Vector a, float s) { return {a.x * s, a.y * s, a.z * s}; }

inline float dot(Vector a, Vector b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
inline bool is_zero(Vector a) { return a.x == 0 && a.y == 0 && a.z == 0; }
inline float largest(Vector a) { return maximum(maximum(a.x, a.y), a.z); }
inline bool any_positive(Vector a) { return a.x > 0 || a.y > 0 || a.z > 0; }

/// Unit length, or zero where the squared length is outside [2^-100, 2^100].
inline Vector unit(Vector v) {
  const float l = dot(v, v);
  if (!(l >= two_pow_minus_100 && l <= two_pow_100)) return {};
  const float s = 1.0f / std::sqrt(l);
  return v * s;
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
