#include <fmt/format.h>

#include "sim/command/shell/shell.h"

namespace artu::sim {
namespace {

/// Inside '...' of _arguments: brackets and colons have a meaning there.
std::string quoted(const std::string& text, const char* special) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
      continue;
    }
    if (std::string(special).find(c) != std::string::npos) out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::string action_of(const OptionInfo& option) {
  switch (option.argument) {
    case Argument::none:
      return "";
    case Argument::other:
      return option.values.empty() ? " " : "(" + joined(option.values) + ")";
    case Argument::file:
      return "_files";
    case Argument::folder:
      return "_files -/";
    case Argument::value:
      return "(" + joined(option.values) + ")";
    case Argument::list:
      return "_values -s , value " + joined(option.values);
    case Argument::parameter:
      return "_artu_parameters";
  }
  return "";
}

std::string argument_line(const OptionInfo& option) {
  std::string out;
  for (const std::string& name : option.names) {
    out += fmt::format("        '*{}[{}]{}'", name, quoted(option.text, "[]:\\"),
                       option.argument == Argument::none
                           ? ""
                           : fmt::format(":{}:{}", quoted(option.placeholder, ":\\"), action_of(option)));
    out += " \\\n";
  }
  return out;
}

}  // namespace

std::string zsh_completion(const std::vector<CommandInfo>& commands) {
  std::string out = "#compdef artu\n# zsh completion of artu; made by `artu completion zsh`\n\n_artu_parameters() {\n";
  std::string paths, values;
  for (const ParameterWords& parameter : parameter_words()) {
    paths += (paths.empty() ? "" : " ") + parameter.path;
    if (!parameter.values.empty()) {
      values += fmt::format("    {}) compadd -- {} ;;\n", parameter.path, joined(parameter.values));
    }
  }
  out += "  if compset -P 1 '*='; then\n    case ${IPREFIX%=} in\n" + values + "    esac\n    return\n  fi\n";
  out += "  compadd -S = -- " + paths + "\n}\n\n_artu() {\n  local -a commands=(\n";
  for (const CommandInfo& command : commands) {
    out += fmt::format("    '{}:{}'\n", command.name, quoted(command.text, ":\\"));
  }
  out +=
      "  )\n  if ((CURRENT == 2)); then\n    _describe command commands\n    return\n  fi\n"
      "  local command=${words[2]}\n  shift words\n  ((CURRENT--))\n  case $command in\n";
  for (const CommandInfo& command : commands) {
    out += fmt::format("    {})\n      _arguments \\\n", command.name);
    for (const OptionInfo& option : command.options) out += argument_line(option);
    out += command.positional_values.empty()
               ? "        '*:file:_files'\n      ;;\n"
               : fmt::format("        '1:word:({})'\n      ;;\n", joined(command.positional_values));
  }
  out += "  esac\n}\n\n_artu \"$@\"\n";
  return out;
}

}  // namespace artu::sim
