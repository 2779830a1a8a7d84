// The scripts say what they are for, and begin nothing that was not asked for.
#include <gmock/gmock.h>

#include <filesystem>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class ScriptsTest : public ProgramTest {
 protected:
  static std::string script(const std::string& name) { return ARTU_SOURCE_DIR "/scripts/" + name; }
  void expect_refused(const std::string& name, const std::vector<std::string>& words, const std::string& text) const {
    const Finished run = program(script(name), words);
    EXPECT_EQ(run.code, 2) << name;
    EXPECT_THAT(run.out, IsEmpty()) << name;
    EXPECT_THAT(run.err, StartsWith("error: ")) << name;
    EXPECT_THAT(run.err, HasSubstr(text)) << name;
  }
};

TEST_F(ScriptsTest, HelpIsWhatEachDoesAndNothingElseIsDone) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(script(""))) {
    const bool executable = (entry.status().permissions() & fs::perms::owner_exec) != fs::perms::none;
    if (!entry.is_regular_file() || !executable) continue;
    const Finished help = program(entry.path().string(), {"--help"});
    EXPECT_EQ(help.code, 0) << entry.path() << help.err;
    EXPECT_FALSE(help.out.empty() && help.err.empty()) << entry.path();
    EXPECT_THAT(help.out + help.err, ::testing::Not(HasSubstr("Traceback"))) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 20);
  EXPECT_THAT(content(), IsEmpty());
}

TEST_F(ScriptsTest, WordsThatAScriptDoesNotTakeAreRefused) {
  for (const char* name : {"setup", "report-pictures", "validation-tables", "builder-table", "skip-table",
                           "sampled-table", "make-samples", "slurm-test", "build"}) {
    expect_refused(name, {"--no-such"}, "--no-such");
  }
  for (const char* name : {"setup", "report-pictures", "validation-tables"})
    expect_refused(name, {"word"}, "it takes 0");
  for (const char* name : {"check", "fuzz", "analytic-table"}) expect_refused(name, {"--no-such"}, "--no-such");
  for (const char* name : {"check-docs", "make-reference", "slurm-test", "make-samples", "dram-crosscheck"}) {
    expect_refused(name, {"no-program"}, "program");
  }
}

TEST_F(ScriptsTest, ATableOfNothingIsNone) {
  setenv("ARTU", ARTU_BINARY, 1);
  expect_refused("sampled-table", {"no-folder"}, "no-folder: no such folder");
  // Where the scene is not there, artu says so, and that is the script's end as well. Names are those of the caller.
  fs::create_directory(path("scenes"));
  const Finished run = program("/usr/bin/env", {"SCENES=none", script("sampled-table"), "scenes"});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("scenes/none.glb: "));
}

/// With packages that are all missing, and an apt-get that cannot get them.
TEST_F(ScriptsTest, ASetupThatFailsLeavesNoFiles) {
  fs::create_directory(path("bin"));
  fs::create_directory(path("temporary"));
  for (const char* tool : {"bash", "dirname", "env", "mktemp", "rm", "tail"}) {
    const Finished found = program("/bin/sh", {"-c", std::string("command -v ") + tool});
    fs::create_symlink(found.out.substr(0, found.out.find('\n')), path("bin/") + tool);
  }
  write("bin/apt-get", "#!/bin/sh\nexit 1\n");
  fs::permissions(path("bin/apt-get"), fs::perms::owner_all);
  fs::create_symlink("apt-get", path("bin/dpkg-query"));
  const Finished run = program("/usr/bin/env", {"PATH=" + path("bin"), "TMPDIR=" + path("temporary"), script("setup")});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("setup: could not install: build-essential"));
  EXPECT_THAT(content("temporary"), IsEmpty());
}

}  // namespace
}  // namespace artu::test
