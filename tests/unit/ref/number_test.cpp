// Rounding by an added constant against a slow one, and arithmetic of 23 bits by way of binary64 against binary32.
#include "ref/number.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "ref/vec.h"

namespace artu::ref {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

template <class F>
bool same(F a, F b) {
  return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

// The definition: the nearest multiple of the quantum, which is exact in both types.
template <class F>
double slowly(F x, int m) {
  if (x == 0 || !(std::fabs(x) < inf)) return static_cast<double>(x);
  int exponent;
  std::frexp(x, &exponent);
  const int q = (exponent - 1 < -126 ? -126 : exponent - 1) - m;
  const F rounded = std::ldexp(std::nearbyint(std::ldexp(x, -q)), q);
  return static_cast<double>(std::fabs(rounded) < 0x1p128 ? rounded : std::copysign(static_cast<F>(inf), x));
}

template <class Check>
void each_width(const Check& check) {
  for (int m = narrowest; m <= widest; ++m) with_number(m, [&](auto format) { check(m, format); });
}

std::vector<float> nasty() {
  std::vector<float> v{0, 0x1p-149f, 0x1p-148f, 0x1.8p-148f, 0x1.fffffcp-127f, 0x1p-126f, 0x1.000002p-126f, 0x1p-134f};
  for (const float x : {1.0f, 1.5f, 3.0f, 0x1p-63f, 0x1p-75f, 0x1p64f, 0x1.555556p-1f, 0x1p127f, 0x1.fffffep127f}) {
    v.insert(v.end(), {std::nextafter(x, 0.0f), x, std::nextafter(x, HUGE_VALF)});
  }
  v.insert(v.end(), {std::nanf(""), HUGE_VALF});
  const std::size_t n = v.size();
  for (std::size_t i = 0; i < n; ++i) v.push_back(-v[i]);
  return v;
}

struct Bits {
  std::mt19937_64 engine{17};
  /// Any bits, or of a moderate exponent, with trailing zeros so that exact cases and ties occur.
  float next() {
    auto b = static_cast<std::uint32_t>(engine());
    const std::uint64_t how = engine();
    if (how & 1) b = (b & 0x80ffffffu) | (0x38u + (how >> 8 & 15)) << 24;
    if (how & 2) b &= ~0u << (how >> 16 & 15);
    float x;
    std::memcpy(&x, &b, sizeof x);
    return x;
  }
};

TEST(Rounding, IsThatOfTheDefinition) {
  std::mt19937_64 random(3);
  each_width([&](int m, auto format) {
    using N = typename decltype(format)::Type;
    const auto check = [m](double x) {
      const double rounded = static_cast<double>(N(x));
      ASSERT_TRUE(same(rounded, slowly(x, m))) << std::hexfloat << x << " " << rounded << " " << m;
      ASSERT_TRUE(same(static_cast<double>(static_cast<float>(N(x))), rounded));
      ASSERT_TRUE(same(static_cast<double>(N(rounded)), rounded));
    };
    // Every exponent that results of binary32 operands can have: values, ties and their neighbours.
    for (int e = -300; e <= 300; ++e) {
      for (int i = 0; i < 40; ++i) {
        const double x = std::ldexp(1 + static_cast<double>(random() >> (12 + i)) * std::ldexp(1.0, i - 52), e);
        const double half = std::ldexp(1.0, (e < -126 ? -126 : e) - m - 1);
        const double tie = (2 * std::floor(x / half / 2) + 1) * half;
        for (const double y : {x, std::nextafter(x, inf), tie, std::nextafter(tie, 0), std::nextafter(tie, inf)}) {
          check(y);
          check(-y);
        }
      }
    }
    const double largest = (2 - std::ldexp(1.0, -m)) * 0x1p127, limit = largest + std::ldexp(1.0, 126 - m);
    EXPECT_EQ(static_cast<float>(N(largest)), static_cast<float>(largest));
    EXPECT_EQ(static_cast<double>(N(std::nextafter(limit, 0))), largest);
    EXPECT_EQ(static_cast<double>(N(limit)), inf);
    EXPECT_EQ(static_cast<double>(N(-limit)), -inf);
    EXPECT_EQ(static_cast<double>(N(std::ldexp(1.0, -127 - m))), 0);  // half the smallest: to even
    EXPECT_EQ(static_cast<double>(N(std::nextafter(std::ldexp(1.0, -127 - m), 1))), std::ldexp(1.0, -126 - m));
    for (const double x : {inf, std::nan(""), 0.0, 0x1p128, 0x1.8p128, 0x1p129, 1e300, 1.7e308, 1e-300, 5e-324}) {
      check(x);
      check(-x);
    }
  });
}

TEST(Rounding, RefusesOtherWidths) {
  for (const int m : {-1, 0, 6, 24, 52}) EXPECT_THROW(with_format(m, [](auto) {}), std::invalid_argument);
  EXPECT_TRUE(with_format(23, [](auto f) { return std::is_same_v<decltype(f), Format<float>>; }));
  EXPECT_TRUE(with_format(22, [](auto f) { return std::is_same_v<decltype(f), Format<Number<22>>>; }));
  EXPECT_TRUE(with_format(7, [](auto f) { return std::is_same_v<decltype(f), Format<Number<7>>>; }));
}

// Against the same operation in more bits: rounding twice does no harm.
TEST(Number, OperationsAreCorrectlyRounded) {
  Bits bits;
  each_width([&](int m, auto format) {
    using N = typename decltype(format)::Type;
    for (int i = 0; i < 50000; ++i) {
      const N a = bits.next(), b = bits.next();
      const auto x = static_cast<long double>(static_cast<double>(a)),
                 y = static_cast<long double>(static_cast<double>(b));
      ASSERT_TRUE(same(static_cast<double>(a + b), slowly(x + y, m)));
      ASSERT_TRUE(same(static_cast<double>(a - b), slowly(x - y, m)));
      ASSERT_TRUE(same(static_cast<double>(a * b), slowly(x * y, m)));
      ASSERT_TRUE(same(static_cast<double>(a / b), slowly(x / y, m)));
      ASSERT_TRUE(same(static_cast<double>(sqrt(a)), slowly(std::sqrt(x), m)));
    }
  });
}

void expect_as_float(float a, float b) {
  const Number<23> x = a, y = b;
  const auto is = [&](Number<23> n, float f) { return same(static_cast<float>(n), f); };
  EXPECT_TRUE(is(x, a));
  EXPECT_TRUE(is(-x, -a));
  EXPECT_TRUE(is(x + y, a + b));
  EXPECT_TRUE(is(x - y, a - b));
  EXPECT_TRUE(is(x * y, a * b));
  EXPECT_TRUE(is(x / y, a / b));
  EXPECT_TRUE(is(sqrt(x), std::sqrt(a)));
  EXPECT_TRUE(is(min(x, y), min(a, b)));
  EXPECT_TRUE(is(max(x, y), max(a, b)));
  EXPECT_EQ(x < y, a < b);
  EXPECT_EQ(x > y, a > b);
  EXPECT_EQ(x <= y, a <= b);
  EXPECT_EQ(x == y, a == b);
  EXPECT_EQ(x != y, a != b);
}

TEST(Number, Of23BitsIsBinary32) {
  for (const float a : nasty()) {
    for (const float b : nasty()) {
      expect_as_float(a, b);
      ASSERT_FALSE(::testing::Test::HasFailure()) << std::hexfloat << a << " " << b;
    }
  }
  Bits bits;
  for (int i = 0; i < 400000; ++i) {
    const float a = bits.next(), b = bits.next();
    expect_as_float(a, b);
    ASSERT_FALSE(::testing::Test::HasFailure()) << std::hexfloat << a << " " << b;
  }
}

}  // namespace
}  // namespace artu::ref
