// The energy section of a report.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

class EnergyTest : public ProgramTest {
 protected:
  EnergyTest() { write_scene("tiny.obj"); }

  json run(const std::string& folder, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> args{"run", "tiny.obj", "--size", "20x14", "--frames", "0:2", "-o", folder};
    args.insert(args.end(), more.begin(), more.end());
    EXPECT_THAT(fine(args).out, HasSubstr(" uJ per frame, "));
    return json::parse(read(folder + "/stats.json"));
  }

  static double sum(const json& shares) {
    double sum = 0;
    for (const auto& [name, share] : shares.items()) sum += share.get<double>();
    return sum;
  }
};

/// A burst that is longer than a line is paid for as a whole.
TEST_F(EnergyTest, TheDramIsPaidByTheByteOnItsBus) {
  const auto dram = [&](const std::string& folder, const std::string& bits) {
    const json stats = run(folder, {"--set", "memory.dram.burst_length=16", "--set", "memory.dram.bus_bits=" + bits});
    const json& counters = stats.at("totals").at("blocks").at("dram");
    const double lines = counters.at("reads").get<double>();
    return stats.at("energy").at("events").at("dram.read").get<double>() / lines;
  };
  const double narrow = dram("narrow", "16"), line = dram("line", "32"), wide = dram("wide", "128");
  EXPECT_NEAR(narrow, line, 1e-9 * line);
  EXPECT_NEAR(wide, 4 * line, 1e-9 * wide);
}

TEST_F(EnergyTest, EveryFrameAndTheRunHaveASection) {
  const json stats = run("out");
  const json& all = stats.at("energy");
  double frames = 0;
  for (const json& frame : stats.at("frames")) {
    const double own = frame.at("energy").at("frame_uj");
    EXPECT_GT(own, 0);
    EXPECT_NEAR(sum(frame.at("energy").at("blocks")), own, 1e-9 * own);
    frames += own;
  }
  const double total = all.at("total_uj");
  EXPECT_NEAR(frames, total, 1e-9 * total);
  EXPECT_NEAR(sum(all.at("blocks")), total / 2, 1e-9 * total);
  EXPECT_NEAR(sum(all.at("events")), total / 2, 1e-9 * total);
  for (const char* block : {"core.traversal", "core.intersection", "core.node_cache", "l2", "dram", "interconnect",
                            "tree_builder", "collision_counter", "static"}) {
    EXPECT_TRUE(all.at("blocks").contains(block)) << block;
  }
  const double cycles = stats.at("totals").at("cycles");
  EXPECT_NEAR(all.at("power_mw").get<double>(), total / cycles * 500 * 1000, 1e-6);
  const json& rays = stats.at("totals").at("rays");
  EXPECT_NEAR(all.at("ray_nj").get<double>(), total * 1000 / sum(rays), 1e-6 * total);
}

TEST_F(EnergyTest, TheTextHasTheTableAndTheNumbers) {
  run("out");
  const std::string text = read("out/stats.txt");
  EXPECT_THAT(text, HasSubstr("# Where does the energy go"));
  EXPECT_THAT(text, ContainsRegex("core.traversal +[0-9.]+ +[0-9.]+ +[0-9.]+%\n"));
  EXPECT_THAT(text, ContainsRegex("\nall +[0-9.]+ +[0-9.]+ +100.0%\n"));
  EXPECT_THAT(text, ContainsRegex("energy.power_mw +[0-9.]+ +mW "));
  EXPECT_THAT(text, ContainsRegex("energy.events.dram.activate +[0-9.]+ +uJ "));
}

TEST_F(EnergyTest, PricesChangeTheEnergyAndNothingElse) {
  json dear = run("a"), cheap = run("b", {"--set", "energy.dram.read=0", "--set", "energy.leakage.core=0"});
  EXPECT_LT(cheap.at("energy").at("total_uj"), dear.at("energy").at("total_uj"));
  EXPECT_EQ(cheap.at("energy").at("events").at("dram.read"), 0);
  for (json* stats : {&dear, &cheap}) {
    stats->erase("simulation");
    stats->erase("energy");
    for (json& frame : stats->at("frames")) frame.erase("energy");
  }
  EXPECT_EQ(dear, cheap);
  EXPECT_THAT(refused({"run", "tiny.obj", "--set", "energy.dram.read=-1"}), HasSubstr("0 ... 10000 pJ/byte"));
}

}  // namespace
}  // namespace artu::test
