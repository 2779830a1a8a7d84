// The commands and their options as shells and manuals need them, taken from the command line's own declarations.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace artu::sim {

/// What follows an option, or stands for itself.
enum class Argument : std::uint8_t {
  none,   // a flag
  other,  // a number or text that nobody can guess
  file,   // a file or a folder
  folder,
  value,      // one of `values`
  list,       // some of `values`, between commas
  parameter,  // path=value
};

struct OptionInfo {
  std::vector<std::string> names;  // "--output", "-o": long ones first
  std::string placeholder;         // "DIR"; "" of a flag
  std::string text, group;
  Argument argument = Argument::none;
  std::vector<std::string> values;
};

struct CommandInfo {
  std::string name, text, group;
  std::vector<std::string> positionals;  // "SCENE|TRACE", "[FILE]" where it may be left out
  std::vector<std::string> positional_texts;
  std::vector<std::string> positional_values;  // where these are words: of all of them
  std::vector<OptionInfo> options;
  std::string examples;  // as in --help
};

/// In the order of `artu --help`.
std::vector<CommandInfo> describe_commands(const CLI::App& app);

/// A parameter of the unit, and its values where they are words.
struct ParameterWords {
  std::string path;
  std::vector<std::string> values;
};
std::vector<ParameterWords> parameter_words();

}  // namespace artu::sim
