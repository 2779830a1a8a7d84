// Configuration: every error names its place and what would be right; what is dumped loads again to the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "hw/selective/policy.h"
#include "sim/config/configuration.h"
#include "sim/config/dump.h"
#include "sim/config/parameter_list.h"
#include "traces/error.h"
#include "unit/sim/temp_folder.h"

namespace artu::sim {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ConfigTest : public ::testing::Test {
 protected:
  const std::string& write(const std::string& text) {
    std::ofstream(file_) << text;
    return file_;
  }

  hw::UnitConfig load(const std::string& text) {
    Configuration configuration;
    configuration.load(write(text));
    configuration.check();
    return configuration.unit();
  }

  /// The message, with "FILE" for the file's name.
  std::string load_error(const std::string& text) {
    try {
      load(text);
    } catch (const InputError& error) {
      std::string what = error.what();
      EXPECT_THAT(what, StartsWith(file_));
      EXPECT_EQ(what.find('\n'), std::string::npos) << "more than one line";
      return "FILE" + what.substr(file_.size());
    }
    ADD_FAILURE() << "no error for: " << text;
    return "";
  }

  static std::string set_error(const std::string& assignment) {
    Configuration configuration;
    try {
      configuration.set(assignment);
      configuration.check();
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "no error for: " << assignment;
    return "";
  }

  const test::TempFolder folder_;
  const std::string file_ = folder_.path("unit.toml");
};

TEST_F(ConfigTest, FileSetsWhatItNamesAndLeavesTheRest) {
  const hw::UnitConfig unit = load(
      "[core]\ncount = 3\nnode_cache = {size = \"32KiB\", ways = 2}\n[selective]\nenabled = false\n"
      "magnitude = \"progressive\"\ntable = [0, 0, 0, 0, 0, 0, 0, 9]\n[shading]\nmin_weight = 0.25\n");
  EXPECT_EQ(unit.core.count, 3u);
  EXPECT_EQ(unit.core.node_cache.size, 32768u);
  EXPECT_EQ(unit.core.node_cache.ways, 2u);
  EXPECT_EQ(unit.core.triangle_cache.size, hw::UnitConfig().core.triangle_cache.size);
  EXPECT_FALSE(unit.selective.enabled);
  EXPECT_EQ(unit.selective.magnitude, hw::Magnitude::progressive);
  EXPECT_EQ(unit.selective.table[7], 9u);
  EXPECT_EQ(unit.shading.min_weight, 0.25f);
}

TEST_F(ConfigTest, WhatIsDumpedLoadsAgainToTheSame) {
  Configuration configuration;
  for (const char* assignment :
       {"core.count=2", "core.node_cache.size=1MiB", "selective.magnitude=fixed", "selective.adaptive=false",
        "selective.table=[1,2,3,4,5,6,7,8]", "shading.min_weight=0.1", "unit.watchdog=4000000000"}) {
    configuration.set(assignment);
  }
  const std::string dumped = dump_config(configuration.unit());
  const hw::UnitConfig again = load(dumped);
  EXPECT_EQ(dump_config(again), dumped);
  EXPECT_EQ(again.core.node_cache.size, 1u << 20);
  EXPECT_EQ(again.shading.min_weight, 0.1f);
  EXPECT_EQ(again.watchdog, 4000000000u);
}

TEST_F(ConfigTest, RealsKeepEveryBit) {
  for (const float value : {0.0f, 1.0f, 0.1f, 1.0e-30f, 0.333333343f, 1.17549435e-38f}) {
    hw::UnitConfig unit;
    unit.shading.min_weight = value;
    EXPECT_EQ(load(dump_config(unit)).shading.min_weight, value);
  }
}

TEST_F(ConfigTest, UnknownKeyNamesItsLineAndTheNearestParameter) {
  EXPECT_EQ(load_error("[core]\ncount = 2\ncontext = 4\n"),
            "FILE:3: unknown parameter core.context; did you mean core.contexts?");
  EXPECT_EQ(load_error("# none\n[cores]\ncount = 2\n"),
            "FILE:3: unknown parameter cores.count; did you mean core.count?");
  EXPECT_EQ(load_error("clock_mhz = 2\n"), "FILE:1: unknown parameter clock_mhz; did you mean unit.clock_mhz?");
  EXPECT_EQ(load_error("\n[empty]\n"),
            "FILE:2: unknown parameter empty; one of those that artu run --list-params prints would be right");
}

TEST_F(ConfigTest, OfSeveralUnknownKeysTheFirstInTheFileIsNamed) {
  EXPECT_THAT(load_error("[unit]\nzzz = 1\n[core]\naaa = 1\n"), StartsWith("FILE:2: unknown parameter unit.zzz"));
}

TEST_F(ConfigTest, WrongTypesAreNamedWithWhatWouldBeRight) {
  EXPECT_EQ(load_error("[core]\n\ncount = \"two\"\n"),
            "FILE:3: core.count = \"two\" is not an integer; 1 ... 64 would be right");
  EXPECT_EQ(load_error("core.count = 2.5"), "FILE:1: core.count = 2.5 is not an integer; 1 ... 64 would be right");
  EXPECT_EQ(load_error("core.count = \"2KiB\""),
            "FILE:1: core.count = \"2KiB\" is not an integer; 1 ... 64 would be right");  // not in bytes
  EXPECT_EQ(load_error("selective.enabled = 1"),
            "FILE:1: selective.enabled = 1 is not a flag; true or false would be right");
  EXPECT_EQ(load_error("shading.min_weight = true"),
            "FILE:1: shading.min_weight = true is not a number; 0 ... 1 would be right");
  EXPECT_EQ(load_error("selective.magnitude = 3"),
            "FILE:1: selective.magnitude = 3 is not a choice; one of fixed, proportional, progressive would be right");
  EXPECT_EQ(load_error("selective.table = [1, 2]"),
            "FILE:1: selective.table is an array of 2; an array of 8 integers would be right");
  EXPECT_EQ(load_error("core = 7"), "FILE:1: core is a group of parameters, not 7; a [core] section would be right");
}

TEST_F(ConfigTest, ARealThatIsAnIntegersValueIsShownAsOne) {
  EXPECT_EQ(load_error("core.count = 4.0"), "FILE:1: core.count = 4.0 is not an integer; 4 would be right");
  EXPECT_EQ(load_error("core.count = 1e3"), "FILE:1: core.count = 1000.0 is not an integer; 1 ... 64 would be right");
  EXPECT_EQ(load_error("core.count = inf"), "FILE:1: core.count = inf is not an integer; 1 ... 64 would be right");
}

TEST_F(ConfigTest, WhatIsTooLongForAnIntegerIsOutOfRange) {
  EXPECT_EQ(set_error("core.count=99999999999999999999999"),
            "--set: core.count = 99999999999999999999999 is out of range; 1 ... 64 would be right");
  EXPECT_THAT(set_error("core.count=-99999999999999999999999"), HasSubstr("is out of range"));
  for (const char* size : {"99999999999999GiB", "99999999999999999999999", "99999999999999999999999 KiB"}) {
    EXPECT_THAT(set_error(std::string("memory.l2.size=") + size), HasSubstr("is out of range; 256 ... ")) << size;
  }
  Configuration configuration;
  configuration.set("memory.l2.size=\"00000000000000000000064KiB\"");
  EXPECT_EQ(configuration.unit().memory.l2.size, 65536u);
}

TEST_F(ConfigTest, WhatAnL2IsToldToHaveIsRight) {
  EXPECT_THAT(load_error("[memory.l2]\nsize = 256\n"), HasSubstr("memory.l2.size = 256; 1 way would be right"));
  EXPECT_EQ(load("[memory.l2]\nsize = 256\nways = 1\n").memory.l2.ways, 1u);
  EXPECT_THAT(load_error("[memory]\nl2_banks = 16\n[memory.l2]\nsize = 256\n"),
              HasSubstr("1 way and memory.l2_banks = 4 would be right"));
  EXPECT_EQ(load("[memory]\nl2_banks = 4\n[memory.l2]\nsize = 256\nways = 1\n").memory.l2_banks, 4u);
  EXPECT_THAT(load_error("[core.node_cache]\nsize = 256\nways = 8\n"), HasSubstr("at most 4 ways would be right"));
}

TEST_F(ConfigTest, ChoicesOfSelectiveRendering) {
  const hw::SelectiveConfig selective =
      load(
          "[selective]\nstride = 4\npasses = \"average\"\ncount = \"merged\"\ncompare = \"reference-count\"\n"
          "reference_count = 8\nmetric = \"luma\"\npolicy = \"fixed\"\npolicy_registers = [1, 2, 3, 255]\n")
          .selective;
  EXPECT_EQ(selective.stride, 4u);
  EXPECT_EQ(selective.passes, hw::Passes::average);
  EXPECT_EQ(selective.compare, hw::Compare::reference_count);
  EXPECT_EQ(selective.reference_count, 8u);
  EXPECT_EQ(selective.metric, hw::Metric::luma);
  EXPECT_STREQ(hw::policy_names()[selective.policy], "fixed");
  EXPECT_EQ(selective.policy_registers, (std::array<std::uint32_t, 4>{1, 2, 3, 255}));
  EXPECT_EQ(load("selective.metric = \"sum\"").selective.metric, hw::Metric::sum);
  EXPECT_EQ(load_error("selective.policy_registers = [1, 2, 3]"),
            "FILE:1: selective.policy_registers is an array of 3; an array of 4 integers would be right");
  EXPECT_EQ(load_error("selective.policy_registers = [1, 2, 3, 256]"),
            "FILE:1: selective.policy_registers[3] = 256 is out of range; 0 ... 255 would be right");
  EXPECT_EQ(
      load_error("selective.passes = \"diagonal\""),
      "FILE:1: selective.passes = \"diagonal\" is not a choice; one of horizontal-vertical, average would be right");
  EXPECT_THAT(load_error("selective.policy = \"nearest\""),
              HasSubstr("\"nearest\" is not a choice; one of attention, "));
  EXPECT_THAT(load_error("selective.reference_count = 9"), HasSubstr("0 ... 8 hits would be right"));
}

TEST_F(ConfigTest, RangesAreEnforced) {
  EXPECT_EQ(load_error("[core]\ncount = 0"), "FILE:2: core.count = 0 is out of range; 1 ... 64 would be right");
  EXPECT_THAT(load_error("core.count = -9223372036854775808"), HasSubstr("is out of range"));
  EXPECT_EQ(load_error("selective.table = [1, 2, 3, 4, 5, 6, 7,\n256]"),
            "FILE:2: selective.table[7] = 256 is out of range; 0 ... 255 codes would be right");
  EXPECT_THAT(load_error("shading.min_weight = nan"), HasSubstr("is out of range; 0 ... 1 would be right"));
  EXPECT_THAT(load_error("core.node_cache.size = \"999GiB\""), HasSubstr("is out of range"));
}

TEST_F(ConfigTest, PowersOfTwoAreEnforced) {
  EXPECT_EQ(load_error("core.node_cache.size = 5000"),
            "FILE:1: core.node_cache.size = 5000 is not a power of two; 4096 or 8192 would be right");
  EXPECT_EQ(load_error("selective.stride = 3"),
            "FILE:1: selective.stride = 3 is not a power of two; 2 or 4 would be right");
  EXPECT_EQ(load_error("selective.stride = 1"),
            "FILE:1: selective.stride = 1 is out of range; 2 ... 8, a power of two pixels would be right");
}

TEST_F(ConfigTest, BadTomlNamesTheLine) {
  EXPECT_THAT(load_error("[core]\ncount = = 3\n"), StartsWith("FILE:2: not valid TOML: "));
  EXPECT_THAT(load_error("[core]\ncount = 1\ncount = 2\n"), StartsWith("FILE:3: not valid TOML: "));
}

TEST_F(ConfigTest, AFileThatCannotBeReadIsNamed) {
  Configuration configuration;
  EXPECT_THROW(configuration.load("/nonexistent/unit.toml"), InputError);
  EXPECT_THROW(configuration.load(::testing::TempDir()), InputError);
}

TEST_F(ConfigTest, CrossChecksNameTheLineOfTheParameter) {
  EXPECT_EQ(load_error("[selective]\nmaximum = 10\nminimum = 20\n"),
            "FILE:3: selective.minimum = 20 is above selective.maximum = 10; at most 10 would be right");
  EXPECT_EQ(load_error("[selective]\nstride = 8\ntile = 4\n"),
            "FILE:2: selective.stride = 8 is above selective.tile = 4; at most 4 would be right");
  EXPECT_EQ(
      load_error("[selective]\npolicy = \"fixed\"\ncount = \"merged\"\n"),
      "FILE:3: selective.count = merged does not go with selective.compare = dynamic-vs-static, which needs the two "
      "counts apart; count = per-class or compare = reference-count would be right");
  EXPECT_EQ(load("[selective]\ncount = \"merged\"\ncompare = \"reference-count\"\n").selective.count,
            hw::Count::merged);
  EXPECT_EQ(load_error("[memory.l2]\nsize = \"1KiB\"\nways = 32\n"),
            "FILE:3: memory.l2.ways = 32 needs 2048 bytes in lines of 64, more than memory.l2.size = 1024; "
            "at most 4 ways would be right");
}

TEST_F(ConfigTest, SetGivesTheSameErrorsWithItsOwnPlace) {
  EXPECT_EQ(set_error("core.count=65"), "--set: core.count = 65 is out of range; 1 ... 64 would be right");
  EXPECT_EQ(set_error("core.cuont=6"), "--set: unknown parameter core.cuont; did you mean core.count?");
  EXPECT_EQ(set_error("core.count=six"), "--set: core.count = \"six\" is not an integer; 1 ... 64 would be right");
  EXPECT_EQ(set_error("core.count="), "--set: core.count = \"\" is not an integer; 1 ... 64 would be right");
  EXPECT_THAT(set_error("core.count"), StartsWith("--set: \"core.count\" is not an assignment; path=value"));
  EXPECT_THAT(set_error("core={count=3}"),
              StartsWith("--set: unknown parameter core, which is a group; a parameter of it, such as core."));
  for (const char* none : {"energy.foo", "foo.x", "", "foo"}) {
    EXPECT_EQ(set_error(std::string(none) + "=4"),
              std::string("--set: unknown parameter ") + none +
                  "; one of those that artu run --list-params prints would be right");
  }
  EXPECT_THAT(set_error("selective.minimum=255\nselective.maximum=3"), HasSubstr("is not an assignment"));
  EXPECT_THAT(set_error("selective.magnitude=\\\""), HasSubstr("is not a choice"));
}

TEST_F(ConfigTest, SetTakesTheLastValueAndKeepsWhatWasThereOnAnError) {
  Configuration configuration;
  configuration.load(write("core.count = 2"));
  configuration.set("core.count=3");
  configuration.set(" core.node_cache.size = 64 KiB ");
  EXPECT_THROW(configuration.set("core.count=1000"), InputError);
  EXPECT_EQ(configuration.unit().core.count, 3u);
  EXPECT_EQ(configuration.unit().core.node_cache.size, 65536u);
}

TEST_F(ConfigTest, ADramPresetSetsThePartAndWhatIsGivenBesideItStays) {
  Configuration file;
  file.load(write("[memory.dram]\nt_cl = 99\nchannels = 4\npreset = \"lpddr5-6400\"\n"));
  EXPECT_EQ(file.unit().memory.dram.clock_mhz, 3200u);
  EXPECT_EQ(file.unit().memory.dram.bank_groups, 4u);
  EXPECT_EQ(file.unit().memory.dram.t_cl, 99u);
  EXPECT_EQ(file.unit().memory.dram.channels, 4u);
  file.set("memory.dram.t_rcd=50");
  EXPECT_EQ(file.unit().memory.dram.t_rcd, 50u);
  file.set("memory.dram.preset=lpddr4x-4266");
  EXPECT_EQ(file.unit().memory.dram.t_rcd, 39u) << "a preset takes everything of a part";
  EXPECT_EQ(file.unit().memory.dram.channels, 4u);
  // The defaults are a preset as well.
  Configuration defaults;
  hw::DramConfig part;
  hw::apply(hw::DramPreset::lpddr4_3200, part);
  const hw::DramConfig own = defaults.unit().memory.dram;
  EXPECT_EQ(own.t_rfc, part.t_rfc);
  EXPECT_EQ(own.t_refi, part.t_refi);
  EXPECT_EQ(own.t_rrd + own.t_faw + own.t_wr + own.t_wtr_s, part.t_rrd + part.t_faw + part.t_wr + part.t_wtr_s);
  EXPECT_EQ(own.t_rcd + own.t_rp + own.t_ras + own.t_rtp, part.t_rcd + part.t_rp + part.t_ras + part.t_rtp);
}

TEST_F(ConfigTest, DramParametersMustFitEachOther) {
  EXPECT_EQ(
      load_error("[memory.dram]\nwrite_high = 40\n"),
      "FILE:2: memory.dram.write_high = 40 is above memory.dram.write_queue_depth = 32; at most 32 would be right");
  EXPECT_EQ(load_error("[memory.dram]\nwrite_low = 24\n"),
            "FILE:2: memory.dram.write_low = 24 is not below memory.dram.write_high = 24; at most 23 would be right");
  EXPECT_EQ(load_error("[memory.dram]\nbank_groups = 16\n"),
            "FILE:2: memory.dram.bank_groups = 16 is above memory.dram.banks = 8; at most 8 would be right");
}

TEST_F(ConfigTest, BetweenTwoRefreshesARowCanBeRead) {
  EXPECT_EQ(load_error("[memory.dram]\nt_refi = 186\n"),
            "FILE:2: memory.dram.t_refi = 186 leaves no time between refreshes: t_rfc + t_rp_all + t_ras + t_rcd + the "
            "longer of t_faw and t_rrd is 643; at least 644 would be right");
  EXPECT_THAT(load_error("[memory.dram]\nrefresh = \"per-bank\"\nt_rfc_bank = 90000\n"),
              AllOf(StartsWith("FILE:3: memory.dram.t_refi = "), HasSubstr("t_rfc_bank + t_rp + ")));
  EXPECT_EQ(load("[memory.dram]\nt_refi = 644\n").memory.dram.t_refi, 644u);
  EXPECT_EQ(load("[memory.dram]\nt_refi = 186\nrefresh = \"none\"\n").memory.dram.t_refi, 186u);
}

TEST_F(ConfigTest, KdTreesAreBuiltAnewAndBySahAlone) {
  const std::string kd = "[accel.dynamic]\nkind = \"kd\"\n[tree_builder]\n";
  EXPECT_EQ(load_error(kd + "algorithm = \"morton\"\n"),
            "FILE:4: tree_builder.algorithm = morton does not go with accel.dynamic.kind = kd; a kd-tree is built anew "
            "by sah, so sah or a BVH would be right");
  EXPECT_EQ(load_error(kd + "refit = true\n"),
            "FILE:4: tree_builder.refit = true does not go with accel.dynamic.kind = kd; a kd-tree is built anew by "
            "sah, so false or a BVH would be right");
  EXPECT_EQ(load(kd + "algorithm = \"sah\"\nrefit = false\n").accel.dynamic_kind, hw::TreeKind::kd);
  EXPECT_TRUE(load("[accel.static]\nkind = \"kd\"\n[tree_builder]\nrefit = true\n").tree_builder.refit);
}

TEST(ParameterList, HasEveryParameterWithItsDefault) {
  const std::string list = format_parameter_list();
  EXPECT_THAT(list, HasSubstr("core.node_cache.size"));
  EXPECT_THAT(list, HasSubstr("\"proportional\""));
  const auto parameters = parameter_list();
  for (const ParameterInfo& parameter : parameters) {
    EXPECT_FALSE(parameter.text.empty()) << parameter.path;
    Configuration configuration;
    EXPECT_NO_THROW(configuration.set(parameter.path + "=" + parameter.default_value)) << parameter.path;
  }
  EXPECT_EQ(nearest_parameter("memory.dram.banks"), "memory.dram.banks");
  EXPECT_EQ(nearest_parameter("dram.bank"), "memory.dram.banks");
}

}  // namespace
}  // namespace artu::sim
