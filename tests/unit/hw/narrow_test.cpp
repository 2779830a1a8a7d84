// Narrow formats: rounding, and the narrow path at 23 bits against the native one (docs/arithmetic.md section 1).
#include "hw/datapath/narrow.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "hw/datapath/vector.h"

namespace artu::hw::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// By the definition, with steps and nearbyint: slow and plain.
float by_definition(double x, int m) {
  if (x == 0 || std::isnan(x) || std::isinf(x)) return static_cast<float>(x);
  const int exponent = std::max(std::ilogb(x), -126);
  const double step = std::ldexp(1.0, exponent - m);
  const double result = std::nearbyint(x / step) * step;
  return std::fabs(result) >= 0x1p128 ? static_cast<float>(std::copysign(infinity, x)) : static_cast<float>(result);
}

void expect_rounded(double x, int m) {
  const float want = by_definition(x, m), got = rounded(x, m);
  if (std::isnan(want)) {
    EXPECT_TRUE(std::isnan(got));
  } else {
    ASSERT_EQ(bits_of(want), bits_of(got)) << std::hexfloat << x << " to " << m << " bits";
  }
}

TEST(Rounding, IsToTheNearestTiesToEvenAtEveryWidth) {
  std::mt19937_64 random(1);
  for (int m = fewest_fraction_bits; m <= most_fraction_bits; ++m) {
    for (int i = 0; i < 20000; ++i) {
      // Exponents around the subnormals, around 1 and around the overflow; fractions that often end in a tie.
      const int exponent = (i % 3 == 0 ? -150 : i % 3 == 1 ? -3 : 120) + static_cast<int>(random() % 30);
      double fraction = 1 + std::ldexp(static_cast<double>(random() >> 12), -52);
      if (i % 2 == 0) {
        fraction = std::floor(std::ldexp(fraction, m + 1)) * std::ldexp(1.0, -m - 1);
        if (i % 4 == 0) fraction += (random() % 3 - 1.0) * 0x1p-51;
      }
      const double x = std::ldexp(random() % 2 != 0 ? fraction : -fraction, exponent);
      expect_rounded(x, m);
    }
  }
}

TEST(Rounding, KnowsZeroSubnormalsOverflowAndNaN) {
  for (int m = fewest_fraction_bits; m <= most_fraction_bits; ++m) {
    for (double x : {0.0, 0x1p-149, 0x1p-126, 0x1p-127, 0x1.8p-133, 0x1p-1000, 0x1p128, 0x1.ffffffffffffp127, infinity,
                     std::ldexp(1.0, -126 - m), std::ldexp(0.5, -126 - m), std::ldexp(0.75, -126 - m)}) {
      expect_rounded(x, m);
      expect_rounded(-x, m);
    }
    EXPECT_TRUE(std::isnan(rounded(std::nan(""), m)));
    EXPECT_TRUE(std::signbit(rounded(-0.0, m)));
    const double largest = (2 - std::ldexp(1.0, -m)) * 0x1p127;
    EXPECT_EQ(rounded(largest, m), static_cast<float>(largest));
    EXPECT_TRUE(std::isinf(rounded(largest + std::ldexp(0.5, 127 - m), m)));
    EXPECT_EQ(rounded(1 + std::ldexp(1.0, -m), m), 1 + std::ldexp(1.0f, -m)) << "exact";
    EXPECT_EQ(rounded(1 + std::ldexp(0.5, -m), m), 1.0f) << "a tie goes to even";
  }
}

TEST(Rounding, OfAnOperationIsTheCorrectlyRoundedResult) {
  // long double has 64 bits: enough to see a double rounding of binary64's 53.
  static_assert(std::numeric_limits<long double>::digits >= 64);
  std::mt19937_64 random(2);
  const auto number = [&](int m) {
    return rounded(
        std::ldexp(1 + std::ldexp(static_cast<double>(random() >> 12), -52), static_cast<int>(random() % 40) - 20), m);
  };
  for (int m : {7, 11, 16, 22}) {
    for (int i = 0; i < 20000; ++i) {
      const float a = number(m), b = number(m);
      const auto check = [&](double in_binary64, long double exact) {
        const float result = rounded(in_binary64, m);
        const long double step = result == 0 ? 0.0L : std::ldexp(1.0L, std::ilogb(result) - m);
        ASSERT_LE(std::fabs(result - exact), step / 2) << std::hexfloat << a << " " << b;
      };
      using Wide = long double;
      check(double(a) + b, Wide(a) + b);
      check(double(a) - b, Wide(a) - b);
      check(double(a) * b, Wide(a) * b);
      check(double(a) / b, Wide(a) / b);
      check(std::sqrt(double(a)), std::sqrt(Wide(a)));
    }
  }
}

std::vector<float> nasty_numbers() {
  const float inf = std::numeric_limits<float>::infinity();
  std::vector<float> numbers{0.0f,     1.0f,    0x1p-149f,    0x1p-126f, 0x1.fffffep-127f, 0x1.fffffep127f,
                             0x1p100f, 3.0f,    0.1f,         inf,       0x1.000002p0f,    0x1.fffffep0f,
                             0x1p-75f, 0x1p64f, std::nanf("")};
  for (std::size_t i = 0, n = numbers.size(); i < n; ++i) numbers.push_back(-numbers[i]);
  return numbers;
}

void expect_same(float native, Narrow<23> narrow, float a, float b) {
  const float other = float(narrow);
  if (std::isnan(native)) {
    ASSERT_TRUE(std::isnan(other)) << std::hexfloat << a << " " << b;
  } else {
    ASSERT_EQ(bits_of(native), bits_of(other)) << std::hexfloat << a << " " << b;
  }
}

void expect_same_operations(float a, float b) {
  const Narrow<23> x(a), y(b);
  expect_same(a + b, x + y, a, b);
  expect_same(a - b, x - y, a, b);
  expect_same(a * b, x * y, a, b);
  expect_same(a / b, x / y, a, b);
  expect_same(std::sqrt(a), sqrt(x), a, b);
  expect_same(-a, -x, a, b);
  EXPECT_EQ(a < b, x < y);
  EXPECT_EQ(a > b, x > y);
  EXPECT_EQ(a <= b, x <= y);
  EXPECT_EQ(a >= b, x >= y);
  EXPECT_EQ(a == b, x == y);
  EXPECT_EQ(a != b, x != y);
}

TEST(Narrow, At23BitsIsBinary32) {
  const std::vector<float> nasty = nasty_numbers();
  for (float a : nasty) {
    for (float b : nasty) expect_same_operations(a, b);
  }
  std::mt19937_64 random(3);
  for (int i = 0; i < 300000; ++i) {
    const std::uint64_t bits = random();
    expect_same_operations(float_of(static_cast<std::uint32_t>(bits)),
                           float_of(static_cast<std::uint32_t>(bits >> 32)));
  }
}

TEST(Narrow, RoundsWhatItIsMadeOf) {
  EXPECT_EQ(float(Narrow<7>(1.0f + 0x1p-9f)), 1.0f);
  EXPECT_EQ(float(Narrow<7>(1.0f) / Narrow<7>(3.0f)), 0x1.56p-2f);
  EXPECT_EQ(narrowed(0.1f, 23), 0.1f);
  EXPECT_EQ(narrowed(0.1f, 10), rounded(0.1f, 10));
}

}  // namespace
}  // namespace artu::hw::test
