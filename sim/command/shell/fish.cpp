#include <fmt/format.h>

#include "sim/command/shell/shell.h"

namespace artu::sim {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out + "'";
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::string option_line(const CommandInfo& command, const OptionInfo& option) {
  std::string out = fmt::format("complete -c artu -n '__fish_seen_subcommand_from {}'", command.name);
  for (const std::string& name : option.names) {
    out += name.compare(0, 2, "--") == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  switch (option.argument) {
    case Argument::none:
      break;
    case Argument::other:
    case Argument::value:
      out += " -x";
      if (!option.values.empty()) out += " -a " + quoted(joined(option.values));
      break;
    case Argument::list:
      out += fmt::format(" -x -a \"(__fish_append , {})\"", joined(option.values));
      break;
    case Argument::file:
      out += " -r -F";
      break;
    case Argument::folder:
      out += " -x -a '(__fish_complete_directories)'";
      break;
    case Argument::parameter:
      out += " -x -a '(__artu_parameters)'";
      break;
  }
  return out + " -d " + quoted(option.text) + "\n";
}

}  // namespace

std::string fish_completion(const std::vector<CommandInfo>& commands) {
  std::string out = "# fish completion of artu; made by `artu completion fish`\n\nfunction __artu_parameters\n";
  for (const ParameterWords& parameter : parameter_words()) {
    std::vector<std::string> words;
    for (const std::string& value : parameter.values) words.push_back(parameter.path + "=" + value);
    out += "    printf '%s\\n' " + (words.empty() ? parameter.path + "=" : joined(words)) + "\n";
  }
  out += "end\n\n";
  std::string names;
  for (const CommandInfo& command : commands) names += " " + command.name;
  const std::string none = "not __fish_seen_subcommand_from" + names;
  for (const CommandInfo& command : commands) {
    out += fmt::format("complete -c artu -n '{}' -f -a {} -d {}\n", none, command.name, quoted(command.text));
  }
  for (const CommandInfo& command : commands) {
    for (const OptionInfo& option : command.options) out += option_line(command, option);
    if (command.positional_values.empty()) continue;
    out += fmt::format("complete -c artu -n '__fish_seen_subcommand_from {}' -f -a '{}'\n", command.name,
                       joined(command.positional_values));
  }
  return out;
}

}  // namespace artu::sim
