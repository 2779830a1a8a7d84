// Energy: every event is priced once, by the parameter it is named after, and only counters that exist are used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/command/example_scene.h"
#include "sim/config/configuration.h"
#include "sim/config/parameter_list.h"
#include "sim/driver/frame_simulator.h"
#include "sim/energy/energy.h"
#include "sim/energy/energy_report.h"
#include "sim/energy/prices.h"

namespace artu::sim {
namespace {

using ::testing::HasSubstr;

/// What a real unit counted: one triangle and a light.
const Totals& totals() {
  static const Totals all = [] {
    const traces::Scene scene = example_scene();
    return totals_of(make_simulator(scene, {})->run(example_frame()));
  }();
  return all;
}

hw::UnitConfig with(const std::vector<std::string>& assignments) { return Configuration::of({}, assignments).unit(); }

/// Parameters below `energy.` that price no event, but change what events cost.
const std::set<std::string> laws{"scale", "operators.multiply_overhead", "sram.growth", "wires.core_length",
                                 "wires.chip_length"};

std::vector<std::string> priced_events() {
  std::vector<std::string> events;
  const std::string group = "energy.";
  for (const ParameterInfo& parameter : parameter_list()) {
    if (parameter.path.rfind(group, 0) != 0) continue;
    const std::string name = parameter.path.substr(group.size());
    if (laws.count(name) == 0) events.push_back(name);
  }
  return events;
}

/// A unit in which nothing costs anything but what is given.
hw::UnitConfig free_but(const std::vector<std::string>& assignments) {
  std::vector<std::string> all;
  for (const std::string& event : priced_events()) all.push_back("energy." + event + "=0");
  all.insert(all.end(), assignments.begin(), assignments.end());
  return with(all);
}

double share(const Energy::Shares& shares, const std::string& name) {
  for (const auto& [key, value] : shares) {
    if (key == name) return value;
  }
  ADD_FAILURE() << "no " << name;
  return -1;
}

TEST(EnergyModel, BlocksAndEventsAddUpToTheTotal) {
  const Energy energy = energy_of(totals(), {});
  double blocks = 0, events = 0;
  for (const auto& [block, picojoules] : energy.by_block()) blocks += picojoules;
  for (const auto& [event, picojoules] : energy.by_event()) events += picojoules;
  EXPECT_EQ(blocks, energy.picojoules());
  EXPECT_NEAR(events / blocks, 1, 1e-12);
  EXPECT_GT(blocks, 0);
}

TEST(EnergyModel, EveryEventHasAParameterAndEveryParameterAnEvent) {
  std::set<std::string> events;
  for (const EnergyItem& item : energy_of(totals(), {}).items) events.insert(item.event);
  const std::vector<std::string> priced = priced_events();
  EXPECT_EQ(events, std::set<std::string>(priced.begin(), priced.end()));
}

TEST(EnergyModel, AnEventThatCostsNothingTakesItsShareAwayAndNoOther) {
  const Energy all = energy_of(totals(), {});
  for (const std::string& event : priced_events()) {
    const Energy less = energy_of(totals(), with({"energy." + event + "=0"}));
    ASSERT_EQ(less.items.size(), all.items.size());
    for (std::size_t i = 0; i < all.items.size(); ++i) {
      EXPECT_EQ(less.items[i].count, all.items[i].count);
      EXPECT_EQ(less.items[i].picojoules(), all.items[i].event == event ? 0 : all.items[i].picojoules()) << event;
    }
    EXPECT_NEAR(less.picojoules() + share(all.by_event(), event), all.picojoules(), 1e-12 * all.picojoules()) << event;
  }
}

TEST(EnergyModel, IsLinearInTheCounts) {
  Totals twice = totals();
  add(twice, totals());
  const Energy once = energy_of(totals(), {}), both = energy_of(twice, {});
  for (std::size_t i = 0; i < once.items.size(); ++i) {
    EXPECT_EQ(both.items[i].count, 2 * once.items[i].count) << once.items[i].block << " " << once.items[i].event;
    EXPECT_EQ(both.items[i].picojoules(), 2 * once.items[i].picojoules());
  }
  EXPECT_EQ(both.picojoules(), 2 * once.picojoules());
  EXPECT_EQ(both.milliwatts(), once.milliwatts()) << "twice the energy in twice the time";
}

TEST(EnergyModel, ACounterThatIsMissingIsAnErrorAndNeverZero) {
  const double all = energy_of(totals(), {}).picojoules();
  std::set<std::string> names, missed;
  for (const hw::Statistic& s : totals().statistics) names.insert(s.name);
  for (const std::string& name : names) {
    Totals renamed = totals();
    for (hw::Statistic& s : renamed.statistics) {
      if (s.name == name) s.name = "renamed";
    }
    try {
      EXPECT_EQ(energy_of(renamed, {}).picojoules(), all) << name;
    } catch (const std::logic_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("has no counter " + name));
      missed.insert(name);
    }
  }
  for (const char* used : {"box_tests", "node_visits", "triangle_tests", "hit_points", "lights", "fills", "activates",
                           "requests", "candidates", "triangles", "shadow_rays"}) {
    EXPECT_EQ(missed.count(used), 1u) << used;
  }
  EXPECT_EQ(missed.count("busy"), 0u);
  Totals without = totals();
  for (hw::Statistic& s : without.statistics) {
    if (s.block.rfind("l2_bank", 0) == 0) s.block = "l3";
  }
  EXPECT_THROW(energy_of(without, {}), std::logic_error);
}

TEST(EnergyModel, StaticPowerIsPowerTimesTime) {
  EXPECT_DOUBLE_EQ(energy_of(totals(), free_but({"energy.leakage.core=10"})).milliwatts(), 6 * 10);
  EXPECT_DOUBLE_EQ(energy_of(totals(), free_but({"energy.leakage.core=10", "unit.clock_mhz=250"})).milliwatts(),
                   6 * 10);
  EXPECT_DOUBLE_EQ(energy_of(totals(), free_but({"energy.dram.background=30"})).milliwatts(), 2 * 30);
  // 6 x (16 + 16 + 8) + 4 + 256 KiB
  EXPECT_DOUBLE_EQ(energy_of(totals(), free_but({"energy.leakage.sram=0.5"})).milliwatts(), 500 * 0.5);
}

TEST(EnergyModel, AnAccessToTheL2IsOneToABank) {
  for (const std::uint32_t banks : {1u, 2u, 8u}) {
    const hw::UnitConfig unit = with({"memory.l2_banks=" + std::to_string(banks)});
    const Energy energy = energy_of(totals(), unit);
    const auto item = std::find_if(energy.items.begin(), energy.items.end(),
                                   [](const EnergyItem& i) { return i.block == "l2" && i.event == "sram.access"; });
    ASSERT_NE(item, energy.items.end());
    EXPECT_EQ(item->price, line_price(unit.energy, unit.memory.l2.size / banks)) << banks;
  }
  EXPECT_LT(line_price({}, 65536), line_price({}, 262144)) << "a smaller array is cheaper";
}

TEST(EnergyModel, AnEventCostsItsCountTimesItsPrice) {
  const auto count = [](const std::string& name, const std::string& block) {
    std::uint64_t sum = 0;
    for (const hw::Statistic& s : totals().statistics)
      sum += s.name == name && s.block.find(block) != s.block.npos ? s.value : 0;
    return static_cast<double>(sum);
  };
  const Energy row = energy_of(totals(), free_but({"energy.dram.activate=1000"}));
  EXPECT_EQ(row.picojoules(), 1000 * count("activates", "dram"));
  // A division a triangle test, six a ray set-up, one a primary ray; hits, lights and so on have theirs.
  const Energy divide = energy_of(totals(), free_but({"energy.operators.divide=1", "energy.scale=1"}));
  EXPECT_EQ(share(divide.by_block(), "core.intersection"), count("triangle_tests", "intersection"));
  EXPECT_EQ(share(divide.by_block(), "core.ray_generator"),
            6 * static_cast<double>(totals().rays()) + count("primary_rays", "ray_generator"));
  // Two boxes of a binary node are 14 multiplications.
  const Energy multiply = energy_of(totals(), free_but({"energy.operators.multiply=1", "energy.scale=1"}));
  EXPECT_EQ(share(multiply.by_block(), "core.traversal"), 7 * count("box_tests", "traversal"));
  const Energy twice = energy_of(totals(), free_but({"energy.operators.multiply=1", "energy.scale=2"}));
  EXPECT_EQ(twice.picojoules(), 2 * multiply.picojoules());
  EXPECT_DOUBLE_EQ(
      share(energy_of(totals(), free_but({"energy.sram.access=1", "energy.scale=1"})).by_block(), "core.texture_cache"),
      8 * (count("reads", "texture_cache") + count("fills", "texture_cache")));
}

TEST(EnergyModel, OfTwoKindsOfTreeTheDearerTestIsCharged) {
  const auto traversal = [](const std::vector<std::string>& settings) {
    return share(energy_of(totals(), with(settings)).by_block(), "core.traversal");
  };
  const double narrow = traversal({}), wide = traversal({"accel.static.kind=bvh8", "accel.dynamic.kind=bvh8"});
  EXPECT_LT(narrow, wide);
  EXPECT_EQ(traversal({"accel.dynamic.kind=bvh8"}), wide);
  EXPECT_EQ(traversal({"accel.static.kind=bvh8"}), wide);
}

TEST(EnergyPrices, MeetThePublishedPoints) {
  hw::EnergyConfig energy;
  energy.scale = 1;
  // Horowitz, ISSCC 2014: binary32 and binary16 (10 fraction bits); arrays of 8 KiB, 32 KiB and 1 MiB, 64 bits.
  EXPECT_NEAR(operator_prices(energy, 23).multiply, 3.7, 1e-6);
  EXPECT_NEAR(operator_prices(energy, 10).multiply, 1.1, 0.01);
  EXPECT_NEAR(operator_prices(energy, 23).add, 0.9, 1e-6);
  EXPECT_NEAR(operator_prices(energy, 10).add, 0.4, 0.02);
  EXPECT_EQ(line_price(energy, 8192), 8 * 10.0);
  EXPECT_NEAR(line_price(energy, 32768), 8 * 20.0, 8 * 0.8);
  EXPECT_NEAR(line_price(energy, 1u << 20), 8 * 100.0, 8 * 0.5);
  EXPECT_NEAR(line_price(energy, 4096) * 1.39, 8 * 10.0, 1e-5);
}

TEST(EnergyPrices, ANarrowerDatapathCostsLess) {
  const auto of = [](const char* block, const std::string& setting) {
    return share(energy_of(totals(), with({setting})).by_block(), block);
  };
  EXPECT_LT(of("core.traversal", "precision.box=10"), of("core.traversal", "precision.box=23"));
  EXPECT_EQ(of("core.shading", "precision.box=10"), of("core.shading", "precision.box=23"));
  EXPECT_LT(of("core.shading", "precision.shading=10"), of("core.shading", "precision.shading=23"));
  EXPECT_LT(of("core.intersection", "precision.triangle=10"), of("core.intersection", "precision.triangle=23"));
}

TEST(EnergyReport, NumbersAreRatiosOfTheTotal) {
  Energy energy;
  energy.items = {{"a", "x", 3, 1e6}, {"b", "x", 1, 1e6}, {"a", "y", 4, 1e6}};
  energy.frames = 2;
  energy.rays = 16;
  energy.traced_pixels = 4;
  energy.cycles = 1000;
  energy.clock_mhz = 500;
  const std::vector<Number> numbers = energy_numbers(energy);
  const auto value = [&](const char* name) {
    for (const Number& n : numbers) {
      if (n.name == name) return std::get<double>(n.value);
    }
    return -1.0;
  };
  EXPECT_EQ(value("total_uj"), 8);
  EXPECT_EQ(value("frame_uj"), 4);
  EXPECT_EQ(value("ray_nj"), 500);
  EXPECT_EQ(value("traced_pixel_nj"), 2000);
  EXPECT_DOUBLE_EQ(value("power_mw"), 4000);  // 8 uJ in 2 us
  EXPECT_EQ(std::get<double>(energy_blocks(energy)[0].value), 3.5);
  EXPECT_EQ(std::get<double>(energy_events(energy)[1].value), 2);
  EXPECT_THAT(format_energy_table(energy), HasSubstr("a           3.500    3500.00      87.5%"));
}

TEST(EnergyReport, NothingIsDividedByZero) {
  for (const Number& n : energy_numbers(Energy())) EXPECT_EQ(std::get<double>(n.value), 0) << n.name;
  EXPECT_THAT(format_energy_table(Energy()), HasSubstr("0.0%"));
}

}  // namespace
}  // namespace artu::sim
