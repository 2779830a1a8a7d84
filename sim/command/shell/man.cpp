#include <fmt/format.h>

#include "sim/command/shell/shell.h"

namespace artu::sim {
namespace {

/// Text as roff: a line must not begin with a control character, a backslash and a hyphen of an option are escaped.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string synopsis(const CommandInfo& command) {
  std::string out = ".B artu " + command.name + "\n";
  for (const std::string& name : command.positionals) out += ".I " + roff(name) + "\n";
  return out + ".RI [ options ]\n";
}

std::string option_entry(const OptionInfo& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
  if (!option.placeholder.empty()) names += " \\fI" + roff(option.placeholder) + "\\fR";
  std::string out = ".TP\n" + names + "\n" + roff(option.text) + "\n";
  if (option.argument == Argument::value || option.argument == Argument::list) {
    std::string values;
    for (const std::string& value : option.values) values += (values.empty() ? "" : ", ") + value;
    out += fmt::format("({}: {})\n", option.argument == Argument::list ? "of" : "one of", roff(values));
  }
  return out;
}

std::string command_section(const CommandInfo& command) {
  std::string out = ".SS artu " + command.name + "\n" + synopsis(command) + ".PP\n" + roff(command.text) + ".\n";
  for (std::size_t i = 0; i < command.positionals.size(); ++i) {
    out += ".TP\n.I " + roff(command.positionals[i]) + "\n" + roff(command.positional_texts[i]) + "\n";
  }
  for (const OptionInfo& option : command.options) {
    if (option.names.at(0) != "--help") out += option_entry(option);
  }
  if (!command.examples.empty()) {
    out += ".PP\n.EX\n" + roff(command.examples) + "\n.EE\n";
  }
  return out;
}

constexpr const char* ending = R"(.SH EXIT STATUS
.TP
0
fine
.TP
1
mismatch with the golden model
.TP
2
usage or input: one line on standard error says where, what, and what would be right
.TP
3
dead\-lock: who waits for whom is printed
.TP
4
internal, or an accounting law is violated
.TP
128 + n
ended by signal n; nothing is left behind
.SH FILES
.TP
.I runs/SCENE\-N
folder of a report without
.BR \-\-output :
.I stats.txt
for people,
.I stats.json
for programs,
.I config.toml
to run again, and pictures
)";

}  // namespace

std::string manual_page(const std::vector<CommandInfo>& commands) {
  std::string out = fmt::format(
      ".TH ARTU 1 2026-11-23 \"artu {}\" \"User Commands\"\n.SH NAME\nartu \\- cycle\\-approximate model of a mobile "
      "ray\\-tracing unit\n.SH SYNOPSIS\n",
      ARTU_VERSION);
  for (const CommandInfo& command : commands) out += (out.back() == '\n' ? "" : "\n") + synopsis(command) + ".br\n";
  out +=
      ".B artu \\-\\-help\n.SH DESCRIPTION\n"
      "ARTU simulates frames of a scene on a configurable ray\\-tracing unit with selective rendering, and says how\n"
      "many cycles a frame takes, where they go, and what the picture loses.\n"
      "Every pixel can be compared to the bit with a golden model.\n.SH COMMANDS\n";
  std::string group;
  for (const CommandInfo& command : commands) {
    if (command.group != group) out += std::string(group.empty() ? "" : ".PP\n") + ".B " + upper(command.group) + "\n";
    group = command.group;
    out += ".TP\n.B " + command.name + "\n" + roff(command.text) + "\n";
  }
  out += ".SH OPTIONS\n";
  for (const CommandInfo& command : commands) out += command_section(command);
  return out + ending;
}

}  // namespace artu::sim
