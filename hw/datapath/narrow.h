// Numbers of a narrower format than binary32 (docs/arithmetic.md section 1): 8 exponent bits, M stored fraction bits.
//
// A datapath is written once, as a template on its number type: `float`, or Narrow<M>, which computes in binary64
// and rounds once.  Real<M> is the one to take.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace artu::hw {

inline constexpr int fewest_fraction_bits = 7, most_fraction_bits = 23;

/// x to the nearest value of the format, ties to even.
inline float rounded(double x, int fraction_bits) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  constexpr std::uint64_t magnitude_bits = ~std::uint64_t{0} >> 1;
  constexpr std::uint64_t smallest_normal = std::uint64_t{1023 - 126} << 52, overflow = std::uint64_t{1023 + 128} << 52;
  const std::uint64_t magnitude = bits & magnitude_bits;
  if (magnitude >= overflow) return static_cast<float>(x);  // infinity or NaN
  if (magnitude < smallest_normal) {
    // Subnormals have one step for all: that of a sum with a number of the right size.
    const double shift = std::ldexp(1.5, 52 - 126 - fraction_bits);
    return static_cast<float>(std::copysign((std::fabs(x) + shift) - shift, x));
  }
  const int dropped = 52 - fraction_bits;
  bits += (std::uint64_t{1} << (dropped - 1)) - 1 + (bits >> dropped & 1);
  bits &= ~std::uint64_t{0} << dropped;
  std::memcpy(&x, &bits, sizeof x);
  return static_cast<float>(x);  // 2^128 becomes infinity
}

/// The same for a width that is known at run time only; binary32 as it is.
inline float narrowed(float x, int fraction_bits) {
  return fraction_bits == most_fraction_bits ? x : rounded(x, fraction_bits);
}

template <int M>
class Narrow {
 public:
  Narrow() = default;
  /// Rounds.
  explicit Narrow(float x) : value_(rounded(x, M)) {}
  explicit Narrow(double x) : value_(rounded(x, M)) {}
  explicit operator float() const { return value_; }
  explicit operator double() const { return double(value_); }

  friend Narrow operator+(Narrow a, Narrow b) { return Narrow(double(a.value_) + double(b.value_)); }
  friend Narrow operator-(Narrow a, Narrow b) { return Narrow(double(a.value_) - double(b.value_)); }
  friend Narrow operator*(Narrow a, Narrow b) { return Narrow(double(a.value_) * double(b.value_)); }
  friend Narrow operator/(Narrow a, Narrow b) { return Narrow(double(a.value_) / double(b.value_)); }
  friend Narrow operator-(Narrow a) {
    a.value_ = -a.value_;
    return a;
  }
  friend Narrow sqrt(Narrow a) { return Narrow(std::sqrt(double(a.value_))); }
  friend bool operator<(Narrow a, Narrow b) { return a.value_ < b.value_; }
  friend bool operator>(Narrow a, Narrow b) { return a.value_ > b.value_; }
  friend bool operator<=(Narrow a, Narrow b) { return a.value_ <= b.value_; }
  friend bool operator>=(Narrow a, Narrow b) { return a.value_ >= b.value_; }
  friend bool operator==(Narrow a, Narrow b) { return a.value_ == b.value_; }
  friend bool operator!=(Narrow a, Narrow b) { return a.value_ != b.value_; }

 private:
  float value_ = 0;
};

/// The number type of a width: binary32 is native.
template <int M>
using Real = std::conditional_t<M == most_fraction_bits, float, Narrow<M>>;

using EveryWidth = std::make_integer_sequence<int, most_fraction_bits - fewest_fraction_bits + 1>;

}  // namespace artu::hw
