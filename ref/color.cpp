#include "ref/color.h"

#include <cfloat>
#include <cmath>

namespace artu::ref {
namespace {

// An error of the curve must be far below half an ulp of binary32 for the tables to be right.
static_assert(LDBL_MANT_DIG >= 64, "needs a long double of at least 64 bits of precision");

long double curve(long double c) { return c <= 0.04045L ? c / 12.92L : std::pow((c + 0.055L) / 1.055L, 2.4L); }

float not_below(long double x) {
  float f = static_cast<float>(x);
  while (f < x) f = std::nextafter(f, HUGE_VALF);
  return f;
}

}  // namespace

Srgb::Srgb() {
  for (int code = 0; code < 256; ++code) {
    linear[code] = static_cast<float>(curve(code / 255.0L));
    threshold[code] = code == 0 ? 0 : not_below(curve((code - 0.5L) / 255.0L));
  }
}

std::uint8_t Srgb::encode(float x) const {
  // Binary search for the largest code whose threshold x reaches; a NaN reaches none.
  int code = 0;
  for (int step = 128; step > 0; step >>= 1) {
    if (x >= threshold[code + step]) code += step;
  }
  return static_cast<std::uint8_t>(code);
}

const Srgb& srgb() {
  static const Srgb tables;
  return tables;
}

}  // namespace artu::ref
