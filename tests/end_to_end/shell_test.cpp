// Completion and manual page, in the programs that read them.
#include <gmock/gmock.h>

#include <regex>
#include <set>
#include <sstream>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

class ShellTest : public ProgramTest {
 protected:
  bool has(const std::string& tool) const {
    return program("/bin/sh", {"-c", "command -v " + tool + " >/dev/null"}).code == 0;
  }
  void save(const std::string& name, const std::vector<std::string>& command) const { write(name, fine(command).out); }

  /// What bash offers with the cursor at the end of the line, in an order of its own.
  std::vector<std::string> offered(const std::string& line) const {
    const Finished bash = program("/bin/bash", {"--norc", "-c", R"(
        source ./artu.bash
        COMP_LINE=$1 COMP_POINT=${#1} COMP_WORDBREAKS=$' \t\n"\'@><=;|&(:'
        _artu
        ((${#COMPREPLY[@]} == 0)) || printf '%s\n' "${COMPREPLY[@]}")",
                                                "bash", line});
    EXPECT_EQ(bash.code, 0);
    EXPECT_THAT(bash.err, IsEmpty()) << line;
    std::vector<std::string> words;
    std::istringstream lines(bash.out);
    for (std::string word; std::getline(lines, word);) words.push_back(word);
    return words;
  }
  /// Commands, or options of a command, as its help names them.
  std::set<std::string> in_help(const std::vector<std::string>& command, const std::string& pattern) const {
    std::vector<std::string> words = command;
    words.push_back("--help");
    std::string help = fine(words).out;
    help.resize(help.find("\nExamples:"));
    const std::regex name(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator at(help.begin(), help.end(), name), end; at != end; ++at) found.insert(at->str(1));
    return found;
  }
};

TEST_F(ShellTest, BashOffersEveryCommandAndOption) {
  save("artu.bash", {"completion", "bash"});
  const std::set<std::string> commands = in_help({}, "\n  ([a-z]+) +[A-Z]");
  EXPECT_THAT(commands, Contains("run"));
  EXPECT_THAT(offered("artu "), IsSupersetOf(commands));
  EXPECT_THAT(offered("artu sc"), ElementsAre("scaling"));
  for (const std::string& command : commands) {
    const std::set<std::string> options = in_help({command}, "\n  (?:-[a-z],)?(--[a-z-]+)");
    EXPECT_THAT(offered("artu " + command + " -"), IsSupersetOf(options)) << command;
  }
}

TEST_F(ShellTest, BashOffersValuesThatTheProgramTakes) {
  save("artu.bash", {"completion", "bash"});
  write_scene("tiny.obj");
  EXPECT_THAT(offered("artu run --fidelity e"), ElementsAre("event"));
  for (const std::string option : {"--fidelity", "--pictures", "--memory-trace-format", "--inject-fault", "--frames"}) {
    const std::vector<std::string> values = offered("artu run " + option + " ");
    EXPECT_THAT(values, Not(IsEmpty())) << option;
    for (const std::string& value : values) {
      std::vector<std::string> run{"run", "tiny.obj", "--dry-run", option, value};
      if (value != "sampled") run.insert(run.end(), {"--memory-trace", "x"});
      fine(run);
    }
  }
  EXPECT_THAT(offered("artu run --pictures frame,de"), ElementsAre("frame,decision"));
  EXPECT_THAT(offered("artu completion "), ElementsAre("bash", "zsh", "fish"));
  EXPECT_THAT(offered("artu sweep --backend "), ElementsAre("local", "slurm"));
}

TEST_F(ShellTest, BashOffersParametersAndTheirValues) {
  save("artu.bash", {"completion", "bash"});
  EXPECT_THAT(offered("artu run --set core.que"), ElementsAre("core.queue_depth="));
  // Bash's own word begins behind the =, and so does what is put there.
  EXPECT_THAT(offered("artu run --set core.ray_order=p"), ElementsAre("primary-first"));
  EXPECT_THAT(offered("artu scaling x.glb --vary skip.any_hit=true,f"), ElementsAre("true,false"));
  EXPECT_THAT(offered("artu run --set core.count="), IsEmpty());
  // All of them, and all of their words, are taken.
  std::set<std::string> listed;
  std::istringstream list(fine({"run", "--list-params"}).out);
  for (std::string line; std::getline(list, line);) listed.insert(line.substr(0, line.find(' ')) + "=");
  listed.erase("path=");
  const std::vector<std::string> paths = offered("artu run --set ");
  EXPECT_EQ(std::set<std::string>(paths.begin(), paths.end()), listed);
  for (const std::string path : {"memory.dram.preset=", "accel.static.kind=", "selective.policy=", "skip.shadow="}) {
    const std::vector<std::string> values = offered("artu run --set " + path);
    EXPECT_GE(values.size(), 2u) << path;
    for (const std::string& value : values) fine({"run", "--dump-config", "--set", path + value});
  }
}

TEST_F(ShellTest, BashOffersFilesAndFolders) {
  save("artu.bash", {"completion", "bash"});
  write_scene("tiny.obj");
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "tinyrun"});
  EXPECT_THAT(offered("artu run ti"), ElementsAre("tiny.obj", "tinyrun"));
  EXPECT_THAT(offered("artu run -c ti"), ElementsAre("tiny.obj", "tinyrun"));
  EXPECT_THAT(offered("artu run x -o ti"), ElementsAre("tinyrun"));
}

TEST_F(ShellTest, OtherShellsCanReadTheirs) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    save("artu." + shell, {"completion", shell});
    if (!has(shell)) {
      std::printf("skipped: no %s\n", shell.c_str());
      continue;
    }
    const Finished read = program("/usr/bin/env", {shell, "-n", path("artu." + shell)});
    EXPECT_EQ(read.code, 0) << shell;
    EXPECT_THAT(read.err, IsEmpty()) << shell;
  }
  EXPECT_THAT(refused({"completion", "tcsh"}), HasSubstr("tcsh"));
  EXPECT_THAT(refused({"completion"}), HasSubstr("SHELL"));
}

TEST_F(ShellTest, FishOffersOptionsAndParameters) {
  if (!has("fish")) GTEST_SKIP() << "no fish";
  save("artu.fish", {"completion", "fish"});
  const auto complete = [this](const std::string& line) {
    const Finished fish = program("/usr/bin/env", {"HOME=" + path("."), "fish", "--no-config", "-c",
                                                   "source artu.fish; complete -C'" + line + "'"});
    EXPECT_EQ(fish.code, 0);
    return fish.out;
  };
  EXPECT_THAT(complete("artu sc"), HasSubstr("scaling\t"));
  EXPECT_THAT(complete("artu run --fid"), HasSubstr("--fidelity\t"));
  EXPECT_THAT(complete("artu run --fidelity an"), HasSubstr("analytic"));
  EXPECT_THAT(complete("artu run --set core.ray_order=p"), HasSubstr("core.ray_order=primary-first"));
}

TEST_F(ShellTest, TheManualPageHasNoWarnings) {
  save("artu.1", {"man"});
  const std::string page = read("artu.1");
  for (const std::string& command : in_help({}, "\n  ([a-z]+) +[A-Z]")) {
    EXPECT_THAT(page, HasSubstr(".SS artu " + command + "\n"));
  }
  if (has("groff") && has("grotty")) {
    const Finished groff = program("/usr/bin/env", {"groff", "-man", "-Tutf8", "-ww", path("artu.1")});
    EXPECT_EQ(groff.code, 0);
    EXPECT_THAT(groff.err, IsEmpty());
    EXPECT_THAT(groff.out, HasSubstr("--fidelity"));
  } else {
    std::printf("skipped: no groff\n");
  }
  if (has("mandoc")) {
    const Finished lint = program("/usr/bin/env", {"mandoc", "-Tlint", "-Wwarning", path("artu.1")});
    EXPECT_THAT(lint.out, IsEmpty());
    EXPECT_EQ(lint.code, 0);
  } else {
    std::printf("skipped: no mandoc\n");
  }
}

TEST_F(ShellTest, InstallsProgramCompletionAndManual) {
  const Finished install = program("/usr/bin/env", {"cmake", "--install", ARTU_BINARY_DIR, "--prefix", path("usr")});
  EXPECT_EQ(install.code, 0) << install.err;
  EXPECT_EQ(program(path("usr/bin/artu"), {"man"}).out, read("usr/share/man/man1/artu.1"));
  EXPECT_EQ(fine({"completion", "bash"}).out, read("usr/share/bash-completion/completions/artu"));
  EXPECT_EQ(fine({"completion", "zsh"}).out, read("usr/share/zsh/site-functions/_artu"));
  EXPECT_EQ(fine({"completion", "fish"}).out, read("usr/share/fish/vendor_completions.d/artu.fish"));
}

}  // namespace
}  // namespace artu::test
