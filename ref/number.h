// Numbers of fewer fraction bits than binary32 (docs/arithmetic.md section 1, "Formats"): every operation in binary64,
// then one rounding.  Code that must run in any format is a template on its number type, which is `float` itself for
// binary32.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace artu::ref {

inline constexpr int narrowest = 7, widest = 23;  // stored fraction bits

/// `round_to` from 2^127 on: beside the common path, since only here can the result be infinite.
template <int M>
double round_large(double x) {
  constexpr double magic = 0x1.8p179 / (1 << M);  // 1.5 * 2^(52 + 127 - M), as below
  if (std::fabs(x) < 0x1p128) {
    const double rounded = (x + magic) - magic;
    if (std::fabs(rounded) < 0x1p128) return rounded;
  }
  return x * HUGE_VAL;  // infinity of x's sign, or the NaN
}

/// Rounds to 8 exponent bits and M fraction bits: to nearest, ties to even, with subnormals and infinities.
///
/// A sum with 1.5 * 2^(52 + q) lies where binary64's own ulp is 2^q, so the addition rounds to multiples of 2^q: with
/// q = (exponent of x) - M, at least -126 - M, that is the format's rounding.
template <int M>
inline double round_to(double x) {
  static_assert(narrowest <= M && M <= widest);
  constexpr std::uint64_t one = std::uint64_t{1} << 52;  // of the exponent field
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  std::uint64_t exponent = bits & 0x7ff * one;
  if (__builtin_expect(exponent >= (1023 + 127) * one, 0)) return round_large<M>(x);
  if (exponent < (1023 - 126) * one) exponent = (1023 - 126) * one;
  const std::uint64_t magic_bits = (exponent + (52 - M) * one) | one / 2;
  double magic;
  std::memcpy(&magic, &magic_bits, sizeof magic);
  return std::copysign((x + magic) - magic, x);  // the sum loses the sign of a zero
}

/// A number of M fraction bits.  Anything else that meets one in an operation is rounded to the format first.
template <int M>
class Number {
 public:
  Number() = default;
  Number(double x) : value_(round_to<M>(x)) {}  // implicit: the rounding of an operand
  explicit operator double() const { return value_; }
  explicit operator float() const { return static_cast<float>(value_); }  // exact

  friend Number operator+(Number a, Number b) { return a.value_ + b.value_; }
  friend Number operator-(Number a, Number b) { return a.value_ - b.value_; }
  friend Number operator*(Number a, Number b) { return a.value_ * b.value_; }
  friend Number operator/(Number a, Number b) { return a.value_ / b.value_; }
  friend Number sqrt(Number a) { return std::sqrt(a.value_); }
  friend Number operator-(Number a) { return exactly(-a.value_); }
  friend Number min(Number a, Number b) { return a.value_ < b.value_ ? a : b; }
  friend Number max(Number a, Number b) { return a.value_ > b.value_ ? a : b; }
  friend bool operator<(Number a, Number b) { return a.value_ < b.value_; }
  friend bool operator>(Number a, Number b) { return a.value_ > b.value_; }
  friend bool operator<=(Number a, Number b) { return a.value_ <= b.value_; }
  friend bool operator==(Number a, Number b) { return a.value_ == b.value_; }
  friend bool operator!=(Number a, Number b) { return a.value_ != b.value_; }

 private:
  static Number exactly(double x) {
    Number n;
    n.value_ = x;
    return n;
  }

  double value_ = 0;  // kept in binary64, where the next operation takes place
};

/// Names a number type to a generic lambda.
template <class N>
struct Format {
  using Type = N;
};

/// Calls `f` with the Format of Number<bits>, even for 23; throws std::invalid_argument outside of 7 ... 23.
template <int M = widest, class F>
decltype(auto) with_number(int bits, const F& f) {
  if constexpr (M > narrowest) {
    if (bits != M) return with_number<M - 1>(bits, f);
  } else if (bits != M) {
    throw std::invalid_argument("precision: 7 to 23 fraction bits, not " + std::to_string(bits));
  }
  return f(Format<Number<M>>{});
}

/// The same with `float` for 23: the fast way to the same results.
template <class F>
decltype(auto) with_format(int bits, const F& f) {
  if (bits == widest) return f(Format<float>{});
  return with_number<widest - 1>(bits, f);
}

}  // namespace artu::ref
