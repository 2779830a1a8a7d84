#include "sim/stress/exact.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace artu::sim {
namespace {

using Integer = boost::multiprecision::cpp_int;

/// A binary32 as mantissa * 2^exponent.
struct Parts {
  std::int32_t mantissa;
  int exponent;
};
Parts parts_of(float x) {
  if (x == 0) return {0, 1 << 20};
  int exponent = 0;
  const float m = std::frexp(x, &exponent);
  return {static_cast<std::int32_t>(std::ldexp(m, 24)), exponent - 24};
}

Integer scaled(float x, int exponent) {
  const Parts p = parts_of(x);
  if (p.mantissa == 0) return 0;
  return Integer(p.mantissa) << static_cast<unsigned>(p.exponent - exponent);
}

struct Integer3 {
  Integer x, y, z;
};
Integer3 operator-(const Integer3& a, const Integer3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Integer dot(const Integer3& a, const Integer3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Integer3 cross(const Integer3& a, const Integer3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

int exponent_of(hw::Vector v) {
  return std::min({parts_of(v.x).exponent, parts_of(v.y).exponent, parts_of(v.z).exponent});
}
Integer3 scaled(hw::Vector v, int exponent) {
  return {scaled(v.x, exponent), scaled(v.y, exponent), scaled(v.z, exponent)};
}

/// numerator / denominator * 2^exponent, with over 60 correct bits before it is rounded.
double ratio(Integer numerator, Integer denominator, int exponent) {
  if (numerator == 0) return 0;
  const bool negative = (numerator < 0) != (denominator < 0);
  numerator = abs(numerator);
  denominator = abs(denominator);
  const int shift = static_cast<int>(msb(denominator)) - static_cast<int>(msb(numerator)) + 62;
  if (shift > 0) {
    numerator <<= static_cast<unsigned>(shift);
  } else {
    denominator <<= static_cast<unsigned>(-shift);
  }
  const Integer quotient = numerator / denominator;
  const double magnitude = std::ldexp(static_cast<double>(static_cast<std::uint64_t>(quotient)), exponent - shift);
  return negative ? -magnitude : magnitude;
}

/// |value - numerator / denominator * 2^exponent| / 2^unit
double distance(float value, const Integer& numerator, const Integer& denominator, int exponent, int unit) {
  if (!std::isfinite(value)) return HUGE_VAL;
  const Parts p = parts_of(value);
  const int common = p.mantissa == 0 ? exponent : std::min(p.exponent, exponent);
  const Integer left =
      p.mantissa == 0 ? Integer(0) : (Integer(p.mantissa) * denominator) << static_cast<unsigned>(p.exponent - common);
  const Integer right = numerator << static_cast<unsigned>(exponent - common);
  return std::fabs(ratio(left - right, denominator, common - unit));
}

int ulp_exponent(float t, int bits) { return t == 0 ? -126 - bits : std::max(std::ilogb(t), -126) - bits; }

}  // namespace

Exact exact_test(const hw::Ray& ray, const Corners& triangle, const hw::TriangleHit* hit, int triangle_bits) {
  Exact out;
  const int place = std::min(std::min(exponent_of(ray.origin), exponent_of(triangle[0])),
                             std::min(exponent_of(triangle[1]), exponent_of(triangle[2])));
  const int turn = exponent_of(ray.direction);
  if (place > 1000 || turn > 1000) return out;  // all zero
  const Integer3 origin = scaled(ray.origin, place), d = scaled(ray.direction, turn);
  const Integer3 a = scaled(triangle[0], place), b = scaled(triangle[1], place), c = scaled(triangle[2], place);
  // Moeller and Trumbore's quotients.
  const Integer3 e1 = b - a, e2 = c - a, s = origin - a;
  const Integer3 p = cross(d, e2), q = cross(s, e1);
  const Integer det = dot(e1, p);
  if (det == 0) return out;
  const Integer nb = dot(s, p), nc = dot(d, q), na = det - nb - nc, nt = dot(e2, q);
  out.parallel = false;
  out.a = ratio(na, det, 0);
  out.b = ratio(nb, det, 0);
  out.c = ratio(nc, det, 0);
  out.t = ratio(nt, det, place - turn);
  if (hit != nullptr) {
    out.t_ulps = distance(hit->t, nt, det, place - turn, ulp_exponent(hit->t, triangle_bits));
    out.u_error = distance(hit->U / hit->det, na, det, 0, -1 - triangle_bits);
    out.v_error = distance(hit->V / hit->det, nb, det, 0, -1 - triangle_bits);
  }
  return out;
}

}  // namespace artu::sim
