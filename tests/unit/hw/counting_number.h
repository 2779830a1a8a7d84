// A binary32 that counts what is done with it.  Number<0> stands for `float`, Number<1> for the format R of a datapath.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

namespace counting {

using Binary32 = float;

struct Tally {
  std::uint32_t add = 0, multiply = 0, divide = 0, square_root = 0, compare = 0;
  std::uint32_t to_double = 0;  // operands of exact products
};

template <int Format>
struct Number {
  template <class T>
  using IfArithmetic = std::enable_if_t<std::is_arithmetic_v<T>, int>;

  Number() = default;
  template <class T, IfArithmetic<T> = 0>
  constexpr Number(T value) : value_(static_cast<Binary32>(value)) {}
  template <int Other>
  explicit Number(Number<Other> other) : value_(other.value()) {}
  template <class T, IfArithmetic<T> = 0>
  explicit operator T() const {
    tally.to_double += std::is_same_v<T, double>;
    return static_cast<T>(value_);
  }
  Binary32 value() const { return value_; }

  friend Number operator+(Number a, Number b) { return ++tally.add, Number(a.value_ + b.value_); }
  friend Number operator-(Number a, Number b) { return ++tally.add, Number(a.value_ - b.value_); }
  friend Number operator*(Number a, Number b) { return ++tally.multiply, Number(a.value_ * b.value_); }
  friend Number operator/(Number a, Number b) { return ++tally.divide, Number(a.value_ / b.value_); }
  friend Number operator-(Number a) { return Number(-a.value_); }
  friend bool operator<(Number a, Number b) { return ++tally.compare, a.value_ < b.value_; }
  friend bool operator>(Number a, Number b) { return ++tally.compare, a.value_ > b.value_; }
  friend bool operator<=(Number a, Number b) { return ++tally.compare, a.value_ <= b.value_; }
  friend bool operator>=(Number a, Number b) { return ++tally.compare, a.value_ >= b.value_; }
  friend bool operator==(Number a, Number b) { return ++tally.compare, a.value_ == b.value_; }
  friend bool operator!=(Number a, Number b) { return ++tally.compare, a.value_ != b.value_; }
  friend Number sqrt(Number a) { return ++tally.square_root, Number(std::sqrt(a.value_)); }
  /// With a literal, of which the datapath's templates cannot deduce a common type.
  friend Number minimum(Number a, Binary32 b) { return a < Number(b) ? a : Number(b); }
  friend Number maximum(Number a, Binary32 b) { return a > Number(b) ? a : Number(b); }
  /// Rounding to a narrower format is part of the operator before it.
  friend Number rounded(Number a, int) { return a; }

  static inline Tally tally;
  Binary32 value_;
};

}  // namespace counting

/// Signs and exponents are wires: not counted.
// NOLINTNEXTLINE(cert-dcl58-cpp): the datapaths call them by their full names.
namespace std {
template <int F>
counting::Number<F> sqrt(counting::Number<F> a) {
  return ++counting::Number<F>::tally.square_root, counting::Number<F>(sqrt(a.value()));
}
template <int F>
counting::Number<F> fabs(counting::Number<F> a) {
  return fabs(a.value());
}
template <int F>
counting::Number<F> floor(counting::Number<F> a) {
  return floor(a.value());
}
template <int F>
counting::Number<F> ldexp(counting::Number<F> a, int exponent) {
  return ldexp(a.value(), exponent);
}
template <int F>
int ilogb(counting::Number<F> a) {
  return ilogb(a.value());
}
template <int F>
bool signbit(counting::Number<F> a) {
  return signbit(a.value());
}
template <int F>
counting::Number<F> copysign(counting::Number<F> a, counting::Number<F> b) {
  return copysign(a.value(), b.value());
}
}  // namespace std
