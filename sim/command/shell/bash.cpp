#include <fmt/format.h>

#include "sim/command/shell/shell.h"

namespace artu::sim {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

/// What is the same for every command.  The line is split at blanks by hand: bash also splits at = and :, which are
/// inside our words.
// Not for clang-format: the text is shell, not C++.
// clang-format off
constexpr const char* functions = R"bash(
_artu_words() {  # words that begin with $current
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}

_artu_list() {  # the same behind the last comma
  local before=
  [[ $current == *,* ]] && before=${current%,*},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$1" -- "${current##*,}")
}

_artu_parameters() {
  local path=${current%%=*} before
  if [[ $current != *=* ]]; then
    mapfile -t COMPREPLY < <(compgen -S = -W "$_artu_paths" -- "$current")
    compopt -o nospace 2>/dev/null
    return
  fi
  before=$path=
  [[ $current == *,* ]] && before=${current%,*},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$(_artu_values "$path")" -- "${current#"$before"}")
}

_artu_files() {  # d: folders
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen "-$1" -- "$current")
}

_artu() {
  local line=${COMP_LINE:0:COMP_POINT} words current previous command options i
  read -ra words <<<"$line"
  [[ $line == *[[:blank:]] ]] && words+=("")
  current=${words[-1]} previous=${words[-2]} command=${words[1]}
  COMPREPLY=()
  if ((${#words[@]} <= 2)); then
    _artu_words "$_artu_commands --help --version"
  else
    _artu_argument
  fi
  # What bash has split off before its current word is not repeated.
  local breaks=${COMP_WORDBREAKS//[^=:]/} cut=
  [[ -n $breaks && $current == *["$breaks"]* ]] && cut=${current%"${current##*["$breaks"]}"}
  for i in "${!COMPREPLY[@]}"; do COMPREPLY[i]=${COMPREPLY[i]#"$cut"}; done
}
)bash";
// clang-format on

std::string argument_case(const CommandInfo& command, const OptionInfo& option) {
  std::string pattern;
  for (const std::string& name : option.names) pattern += (pattern.empty() ? "" : "|") + command.name + "/" + name;
  std::string action;
  switch (option.argument) {
    case Argument::none:
      return "";
    case Argument::other:
      action = option.values.empty() ? ":" : fmt::format("_artu_words '{}'", joined(option.values));
      break;
    case Argument::file:
      action = "_artu_files f";
      break;
    case Argument::folder:
      action = "_artu_files d";
      break;
    case Argument::value:
      action = fmt::format("_artu_words '{}'", joined(option.values));
      break;
    case Argument::list:
      action = fmt::format("_artu_list '{}'", joined(option.values));
      break;
    case Argument::parameter:
      action = "_artu_parameters";
      break;
  }
  return fmt::format("    {}) {}; return ;;\n", pattern, action);
}

}  // namespace

std::string bash_completion(const std::vector<CommandInfo>& commands) {
  std::string out = "# bash completion of artu; made by `artu completion bash`\n\n";
  std::string names, arguments, options;
  for (const CommandInfo& command : commands) {
    names += (names.empty() ? "" : " ") + command.name;
    std::string own;
    for (const OptionInfo& option : command.options) {
      own += (own.empty() ? "" : " ") + joined(option.names);
      arguments += argument_case(command, option);
    }
    options += fmt::format("    {}) options='{}' ;;\n", command.name, own);
  }
  out += fmt::format("_artu_commands='{}'\n", names);
  std::string paths, values;
  for (const ParameterWords& parameter : parameter_words()) {
    paths += (paths.empty() ? "" : " ") + parameter.path;
    if (!parameter.values.empty()) {
      values += fmt::format("    {}) echo '{}' ;;\n", parameter.path, joined(parameter.values));
    }
  }
  out += fmt::format("_artu_paths='{}'\n\n", paths);
  out += "_artu_values() {  # of a parameter, where they are words\n  case $1 in\n" + values + "  esac\n}\n";
  out += functions;
  out += "\n_artu_argument() {\n  case $command/$previous in\n" + arguments + "  esac\n  case $command in\n" + options +
         "  esac\n  if [[ $current == -* ]]; then\n    _artu_words \"$options\"\n";
  for (const CommandInfo& command : commands) {
    if (command.positional_values.empty()) continue;
    out += fmt::format("  elif [[ $command == {} ]]; then\n    _artu_words '{}'\n", command.name,
                       joined(command.positional_values));
  }
  out += "  else\n    _artu_files f\n  fi\n}\n\ncomplete -F _artu artu\n";
  return out;
}

}  // namespace artu::sim
