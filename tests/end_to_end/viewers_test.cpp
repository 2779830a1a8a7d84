// `artu run --trace`: what independent readers make of the files.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string samples = std::string(ARTU_SOURCE_DIR) + "/traces/samples/";

class ViewersTest : public ProgramTest {
 protected:
  ViewersTest() { write_scene("tiny.obj"); }

  /// Renders a frame; what it prints is returned.
  std::string run(const std::string& scene, const std::vector<std::string>& more) const {
    std::vector<std::string> args{"run", scene, "-o", "out", "--force"};
    args.insert(args.end(), more.begin(), more.end());
    return fine(args).out;
  }
  std::vector<std::string> tiny(std::vector<std::string> more) const {
    more.insert(more.begin(), {"--size", "40x30"});
    return more;
  }
  /// What the reader of that name, which exits with 0 only if all is right, prints about the run's trace.
  std::string read_by(const std::string& script, const std::string& trace, bool whole) const {
    const Finished reader = program("/usr/bin/env", {"python3", "-B", ARTU_SOURCE_DIR "/tests/end_to_end/" + script,
                                                     trace, "out/stats.json", whole ? "1" : "0"});
    EXPECT_EQ(reader.code, 0) << reader.out << reader.err;
    return reader.out;
  }
};

TEST_F(ViewersTest, ReadersFindTheWholeFrameRight) {
  const auto whole = [this](const std::string& scene, std::vector<std::string> more) {
    more.insert(more.end(), {"--trace", "perfetto", "--trace", "konata", "--trace", "vcd"});
    run(scene, more);
    return read_by("perfetto.py", "out/trace.pftrace", true) + read_by("konata.py", "out/trace.kanata", true) +
           read_by("vcd.py", "out/trace.vcd", true);
  };
  EXPECT_THAT(whole("tiny.obj", tiny({})),
              AllOf(HasSubstr("65 blocks, 206 channels"), HasSubstr("65 blocks, 272 variables")));
  whole("tiny.obj", tiny({"--set", "unit.clock_mhz=533", "--set", "core.count=2"}));
  whole("tiny.obj", tiny({"--random-stall", "--set", "memory.l2_banks=4"}));
  whole(samples + "scene.artu", {"--frames", "1", "--set", "core.stack_entries=8", "--set", "core.stack_overflow=spill",
                                 "--set", "selective.overlap=true", "--set", "tree_builder.overlap=true"});
}

TEST_F(ViewersTest, ATimelineOfTheSameRunChangesNothing) {
  std::vector<std::string> args = tiny({"--trace", "perfetto", "--trace", "vcd"});
  run("tiny.obj", args);
  const std::string perfetto = read("out/trace.pftrace"), vcd = read("out/trace.vcd");
  args.push_back("--timeline");  // its sampler is no block of the unit
  run("tiny.obj", args);
  EXPECT_TRUE(perfetto == read("out/trace.pftrace"));
  EXPECT_TRUE(vcd == read("out/trace.vcd"));
}

TEST_F(ViewersTest, EventAndClockedGiveTheSameBytes) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--random-stall"}, {"--trace-from", "1000", "--trace-to", "2345"}}) {
    std::vector<std::string> args =
        tiny({"--set", "unit.clock_mhz=533", "--trace", "perfetto", "--trace", "konata", "--trace", "vcd"});
    args.insert(args.end(), more.begin(), more.end());
    run("tiny.obj", args);
    std::vector<std::string> event;
    for (const char* name : {"pftrace", "kanata", "vcd"}) event.push_back(read(std::string("out/trace.") + name));
    args.insert(args.end(), {"--fidelity", "clocked"});
    run("tiny.obj", args);
    std::vector<std::string> clocked;
    for (const char* name : {"pftrace", "kanata", "vcd"}) clocked.push_back(read(std::string("out/trace.") + name));
    EXPECT_TRUE(event == clocked);
  }
}

TEST_F(ViewersTest, AWindowHasTheRaysThatAreInFlightInIt) {
  const std::string out =
      run(samples + "mirror_cube.artu", {"--frames", "0", "--trace", "perfetto", "--trace", "konata", "--trace", "vcd",
                                         "--trace-from", "8000", "--trace-to", "9000"});
  EXPECT_THAT(out, HasSubstr("out/trace.pftrace: perfetto, 1000 cycles"));
  EXPECT_THAT(read_by("perfetto.py", "out/trace.pftrace", false),
              AllOf(HasSubstr("65 blocks"), Not(HasSubstr(" 0 flows"))));
  EXPECT_THAT(read_by("konata.py", "out/trace.kanata", false), Not(HasSubstr(" 0 flushed")));
  read_by("vcd.py", "out/trace.vcd", false);
}

TEST_F(ViewersTest, ProtocReadsPerfetto) {
  if (program("/usr/bin/env", {"protoc", "--version"}).code != 0) GTEST_SKIP() << "skipped: no protobuf-compiler";
  run("tiny.obj", tiny({"--trace", "perfetto=frame.pftrace", "--trace-to", "400"}));
  const Finished decoded = program("/bin/sh", {"-c", "protoc --decode_raw <frame.pftrace"});
  EXPECT_EQ(decoded.code, 0) << decoded.err;
  EXPECT_THAT(decoded.out, AllOf(HasSubstr("2: \"stall_mem\""), HasSubstr("2: \"core5\""), HasSubstr("8: 400000")));
}

TEST_F(ViewersTest, TheWaveformProgramsReadTheVcd) {
  if (program("/bin/sh", {"-c", "command -v vcd2fst && command -v fst2vcd"}).code != 0) {
    GTEST_SKIP() << "skipped: no gtkwave";
  }
  run("tiny.obj", tiny({"--trace", "vcd"}));
  const Finished converted =
      program("/bin/sh", {"-c", "vcd2fst out/trace.vcd trace.fst && fst2vcd -f trace.fst -o back.vcd"});
  EXPECT_EQ(converted.code, 0) << converted.out << converted.err;
  const Finished reader = program("/usr/bin/env", {"python3", "-B", ARTU_SOURCE_DIR "/tests/end_to_end/vcd.py",
                                                   "out/trace.vcd", "out/stats.json", "1", "back.vcd"});
  EXPECT_EQ(reader.code, 0) << reader.out << reader.err;
}

TEST_F(ViewersTest, AWindowBehindTheFrameIsEmptyAndSaysSo) {
  const Finished late = fine({"run", "tiny.obj", "--size", "40x30", "-o", "out", "--trace", "perfetto", "--trace-from",
                              "100000000", "--trace", "konata", "--trace", "vcd", "--trace-to", "100000001"});
  EXPECT_THAT(late.err, HasSubstr("note: --trace-from 100000000 is behind the frame's "));
  read_by("perfetto.py", "out/trace.pftrace", false);
  read_by("konata.py", "out/trace.kanata", false);
  read_by("vcd.py", "out/trace.vcd", false);
}

TEST_F(ViewersTest, ChangesNothingElse) {
  run("tiny.obj", tiny({}));
  json without = json::parse(read("out/stats.json"));
  run("tiny.obj", tiny({"--trace", "perfetto"}));
  json with = json::parse(read("out/stats.json"));
  without.erase("simulation");
  with.erase("simulation");
  EXPECT_TRUE(with == without);
}

TEST_F(ViewersTest, BadRequestsAreRefused) {
  write("old", "precious");
  const auto before = content();
  const auto refuses = [&](const std::vector<std::string>& more, const std::string& text) {
    std::vector<std::string> args{"run", "tiny.obj", "--size", "8x8", "-o", "new"};
    args.insert(args.end(), more.begin(), more.end());
    EXPECT_THAT(refused(args), HasSubstr(text));
    EXPECT_EQ(content(), before);
  };
  refuses({"--trace", "waves"}, "\"waves\" is no kind of trace; perfetto, konata or vcd");
  refuses({"--trace", "perfetto="}, "names no file");
  refuses({"--trace", "perfetto=old"}, "--force");
  refuses({"--trace", "perfetto=none/x"}, "none/x");
  refuses({"--trace", "perfetto=same", "--memory-trace", "./same"}, "same is the file of --memory-trace as well");
  refuses({"--trace", "perfetto", "--trace", "perfetto"}, "perfetto is asked for twice");
  refuses({"--trace", "perfetto", "--frames", "0:2"}, "--frames 0 would be right");
  refuses({"--trace", "perfetto", "--jobs", "2"}, "without --jobs");
  refuses({"--trace", "perfetto", "--fidelity", "functional"}, "event would be right");
  refuses({"--trace", "perfetto", "--fidelity", "sampled"}, "event would be right");
  refuses({"--trace", "perfetto", "--trace-from", "7", "--trace-to", "7"}, "a later cycle would be right");
  refuses({"--trace", "perfetto", "--trace-from", "-7"}, "is no cycle");
  refuses({"--trace-from", "7"}, "--trace");
  EXPECT_THAT(refused({"check", "tiny.obj", "--trace", "perfetto"}), HasSubstr("-o DIR"));
  EXPECT_EQ(read("old"), "precious");
}

TEST_F(ViewersTest, AnErrorLeavesNothing) {
  const Finished stuck =
      artu({"run", "tiny.obj", "--size", "8x8", "-o", "new", "--trace", "perfetto=x", "--inject-fault", "dram:3"});
  EXPECT_EQ(stuck.code, 3);
  fine({"run", "tiny.obj", "--size", "8x8", "--trace", "perfetto=x", "--dry-run"});
  EXPECT_THAT(content(), ElementsAre("tiny.obj"));
}

}  // namespace
}  // namespace artu::test
