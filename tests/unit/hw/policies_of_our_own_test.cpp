// contrast and decisions, each rule of docs/selective-rendering.md by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "hw/selective/policy.h"

namespace artu::hw::test {
namespace {

int threshold(const std::string& name, const Evidence& evidence, const SelectiveConfig& config) {
  const auto& names = policy_names();
  const auto found = std::find(names.begin(), names.end(), name);
  EXPECT_NE(found, names.end()) << name;
  return policy(static_cast<std::uint32_t>(found - names.begin())).threshold(evidence, config);
}

SelectiveConfig reference(std::uint32_t value) {
  SelectiveConfig config;
  config.reference = value;
  return config;
}

/// A vertical candidate with grey rows above and below it, all finished.
Evidence between(std::array<int, 3> above, std::array<int, 3> below) {
  Evidence e;
  e.x = 2;
  e.y = 1;
  e.kind = PassKind::vertical;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto grey = [](int code) {
      const auto c = static_cast<std::uint8_t>(code);
      return Rgb{c, c, c};
    };
    e.ring[i] = {true, HitClass::none, grey(above[i])};
    e.ring[i + 5] = {true, HitClass::none, grey(below[i])};
  }
  return e;
}

TEST(Contrast, FallsByHalfOfTheLargestBend) {
  EXPECT_EQ(threshold("contrast", between({10, 10, 10}, {90, 90, 90}), reference(16)), 16);
  EXPECT_EQ(threshold("contrast", between({10, 50, 90}, {5, 5, 5}), reference(16)), 16) << "a slope is no bend";
  EXPECT_EQ(threshold("contrast", between({10, 18, 10}, {5, 5, 5}), reference(16)), 8);
  EXPECT_EQ(threshold("contrast", between({5, 5, 5}, {18, 10, 18}), reference(16)), 8);
  EXPECT_EQ(threshold("contrast", between({10, 18, 10}, {10, 20, 10}), reference(16)), 6);
  EXPECT_EQ(threshold("contrast", between({10, 60, 10}, {5, 5, 5}), reference(16)), 0);
}

TEST(Contrast, EveryChannelCounts) {
  Evidence e = between({10, 10, 10}, {10, 10, 10});
  e.ring[1].color.b = 18;
  EXPECT_EQ(threshold("contrast", e, reference(16)), 8);
  e.ring[6].color.r = 30;
  EXPECT_EQ(threshold("contrast", e, reference(255)), 235);
}

TEST(Contrast, OnlyWholeSidesCount) {
  for (std::size_t missing : {0u, 1u, 2u}) {
    Evidence e = between({10, 60, 10}, {5, 5, 5});
    e.ring[missing] = {};
    EXPECT_EQ(threshold("contrast", e, reference(16)), 16) << missing;
  }
}

TEST(Contrast, ACentreHasFourSides) {
  Evidence e = between({10, 10, 10}, {10, 10, 10});
  e.kind = PassKind::centre;
  e.ring[3] = e.ring[4] = {true, HitClass::none, {10, 10, 10}};
  EXPECT_EQ(threshold("contrast", e, reference(40)), 40);
  e.ring[3].color.g = 20;
  EXPECT_EQ(threshold("contrast", e, reference(40)), 30);
  e.ring[4].color.g = 40;
  EXPECT_EQ(threshold("contrast", e, reference(40)), 10);
}

TEST(Contrast, TheFirstRegisterIsItsWeight) {
  SelectiveConfig config = reference(100);
  config.policy_registers = {16, 0, 0, 0};
  EXPECT_EQ(threshold("contrast", between({10, 18, 10}, {5, 5, 5}), config), 84);
  config.policy_registers = {1, 0, 0, 0};
  EXPECT_EQ(threshold("contrast", between({10, 18, 10}, {5, 5, 5}), config), 99);
}

TEST(Contrast, FallsFurtherNearDynamicGeometryAndIsClamped) {
  Evidence e = between({10, 18, 10}, {5, 5, 5});
  e.counts = {3, 1};
  EXPECT_EQ(threshold("contrast", e, reference(16)), 0);
  EXPECT_EQ(threshold("contrast", e, reference(64)), 34);
  SelectiveConfig config = reference(64);
  config.policy_registers = {0, 16, 0, 0};
  config.step = 0;
  EXPECT_EQ(threshold("contrast", e, config), 56) << "attention off";
  config.minimum = 60;
  EXPECT_EQ(threshold("contrast", e, config), 60);
  config.minimum = 0;
  config.maximum = 20;
  EXPECT_EQ(threshold("contrast", e, config), 20);
}

/// A candidate at (x, y) with these classes around it, row by row; all but `none` are taken as finished.
Evidence among(std::uint16_t x, std::uint16_t y, std::uint8_t h, PassKind kind, std::array<HitClass, 8> classes) {
  Evidence e;
  e.x = x;
  e.y = y;
  e.h = h;
  e.kind = kind;
  for (std::size_t i = 0; i < 8; ++i) e.ring[i] = {classes[i] != HitClass::none, classes[i], {}};
  return e;
}

constexpr HitClass n = HitClass::none, m = HitClass::miss, s = HitClass::static_geometry,
                   d = HitClass::dynamic_geometry;

TEST(Decisions, TracedCandidatesOfTheLevelLowerIt) {
  const auto at = [](std::array<HitClass, 8> classes, std::uint16_t x = 2) {
    return threshold("decisions", among(x, 1, 1, PassKind::vertical, classes), reference(16));
  };
  // Under a sample: the diagonals are candidates, above and below samples.
  EXPECT_EQ(at({n, s, n, n, n, n, s, n}), 16);
  EXPECT_EQ(at({n, s, s, n, n, n, s, n}), 8);
  EXPECT_EQ(at({s, s, n, n, n, s, s, n}), 2);
  EXPECT_EQ(at({s, s, s, n, n, s, s, s}), 2);
  // Under a horizontal candidate: the diagonals are samples, above and below count twice.
  EXPECT_EQ(at({s, n, s, n, n, s, n, s}, 3), 16);
  EXPECT_EQ(at({s, s, s, n, n, s, n, s}, 3), 2);
}

TEST(Decisions, CentresCountTheirFourDirectNeighboursOnce) {
  const auto at = [](std::array<HitClass, 8> classes) {
    return threshold("decisions", among(3, 1, 1, PassKind::centre, classes), reference(16));
  };
  EXPECT_EQ(at({s, n, s, n, n, s, n, s}), 16);
  EXPECT_EQ(at({s, s, s, n, n, s, n, s}), 8);
  EXPECT_EQ(at({s, s, s, s, n, s, n, s}), 2);
}

TEST(Decisions, LargerStridesLookAtTheirOwnLevel) {
  const auto at = [](std::uint16_t x, std::array<HitClass, 8> classes) {
    return threshold("decisions", among(x, 4, 4, PassKind::vertical, classes), reference(16));
  };
  EXPECT_EQ(at(8, {n, s, s, n, n, n, s, n}), 8);
  EXPECT_EQ(at(4, {s, s, s, n, n, s, n, s}), 2);
}

TEST(Decisions, ClassesThatMeetLowerItByAQuarterOrAsTheRegisterSays) {
  const auto at = [](std::array<HitClass, 8> classes, std::uint32_t weight = 0) {
    SelectiveConfig config = reference(16);
    config.policy_registers = {weight, 0, 0, 0};
    return threshold("decisions", among(2, 1, 1, PassKind::vertical, classes), config);
  };
  EXPECT_EQ(at({n, s, n, n, n, n, m, n}), 12);
  EXPECT_EQ(at({n, d, n, n, n, n, m, n}), 12);
  EXPECT_EQ(at({n, m, n, n, n, n, m, n}), 16);
  EXPECT_EQ(at({n, s, n, n, n, n, m, n}, 16), 16);
  EXPECT_EQ(at({n, s, m, n, n, n, s, s}), 1) << "2 by the decisions, then three quarters";
}

TEST(Decisions, FallFurtherNearDynamicGeometry) {
  Evidence e = among(2, 1, 1, PassKind::vertical, {n, d, n, n, n, n, d, n});
  e.counts = {0, 2};
  EXPECT_EQ(threshold("decisions", e, reference(16)), 4);
  EXPECT_EQ(threshold("decisions", e, reference(255)), 183);
}

}  // namespace
}  // namespace artu::hw::test
