// Another program, and what it prints.
#pragma once

#include <string>
#include <vector>

namespace artu::sim {

struct ProgramOutput {
  int code = -1;  // exit code; -1: it is not installed, or was killed
  std::string out;
  std::string err;  // the first line, of what it wrote to stderr, or why it did not start
};

/// Without a shell; `words[0]` is looked for in PATH.
ProgramOutput run_program(const std::vector<std::string>& words);

/// As a word of a POSIX shell.
std::string shell_word(const std::string& text);

}  // namespace artu::sim
