#include "ref/color.h"

#include <cfloat>
#include <cmath>

namespace artu::ref {
namespace {

// An error of the curve must be far below half an ulp of binary32 for its tables to be right.  In those of binary64 a
// last bit may be off, which is far below anything that they are used for.
static_assert(LDBL_MANT_DIG >= 64, "needs a long double of at least 64 bits of precision");

long double curve(long double c) { return c <= 0.04045L ? c / 12.92L : std::pow((c + 0.055L) / 1.055L, 2.4L); }

template <class F>
F not_below(long double x) {
  F f = static_cast<F>(x);
  while (f < x) f = std::nextafter(f, static_cast<F>(HUGE_VAL));
  return f;
}

}  // namespace

template <class F>
SrgbIn<F>::SrgbIn() {
  for (int code = 0; code < 256; ++code) {
    linear[code] = static_cast<F>(curve(code / 255.0L));
    threshold[code] = code == 0 ? 0 : not_below<F>(curve((code - 0.5L) / 255.0L));
  }
}

template <class F>
std::uint8_t SrgbIn<F>::encode(F x) const {
  // Binary search for the largest code whose threshold x reaches; a NaN reaches none.
  int code = 0;
  for (int step = 128; step > 0; step >>= 1) {
    if (x >= threshold[code + step]) code += step;
  }
  return static_cast<std::uint8_t>(code);
}

template <class F>
const SrgbIn<F>& srgb() {
  static const SrgbIn<F> tables;
  return tables;
}

template struct SrgbIn<float>;
template struct SrgbIn<double>;
template const SrgbIn<float>& srgb();
template const SrgbIn<double>& srgb();

}  // namespace artu::ref
