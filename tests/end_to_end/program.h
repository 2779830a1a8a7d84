// The real program as a subprocess, in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "end_to_end/processes.h"

namespace artu::test {

struct Finished {
  int code = -1;  // exit code, or 128 + the signal
  std::string out, err;
};

/// What a file of a report holds, without what says how long it took and how it was called.
std::string repeatable(const std::string& name, const std::string& text);

/// A test in an empty folder, which goes with it.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  /// `artu ARGS`, with the test's folder as its working directory.
  Finished artu(const std::vector<std::string>& args) const;
  /// The same for another program.
  Finished program(const std::string& binary, const std::vector<std::string>& args) const;
  /// The same two beside the test, with what they print on stderr in a file of the test's folder.
  Running start(const std::vector<std::string>& args, const std::string& err = "/dev/null") const;
  Running start_program(const std::string& binary, const std::vector<std::string>& args,
                        const std::string& err = "/dev/null") const;
  /// Kills all that was started.
  void kill_all() const { processes_.end(); }
  /// `artu ARGS`, and expects exit code 0.
  Finished fine(const std::vector<std::string>& args) const;
  /// The same, and expects exit code 2, nothing on stdout, and one line on stderr, which is returned.
  std::string refused(const std::vector<std::string>& args) const;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// Rows of a CSV file, split at commas.
  std::vector<std::vector<std::string>> csv(const std::string& name) const;
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  /// Names of what the folder holds, sorted; of `name` in it.
  std::vector<std::string> content(const std::string& name = ".") const;

  /// A scene of two triangles.
  void write_scene(const std::string& name) const;

 private:
  std::filesystem::path folder_;
  mutable Processes processes_;
};

}  // namespace artu::test
