#include "sim/command/shell/model.h"

#include <algorithm>

#include "sim/config/parameter_list.h"
#include "sim/driver/fidelity.h"
#include "sim/quality/policies.h"
#include "sim/report/picture_set.h"

namespace artu::sim {
namespace {

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> items;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(", ", at), list.size());
    items.push_back(list.substr(at, end - at));
    at = end + 2;
  }
  return items;
}

std::vector<std::string> fidelities() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < fidelity_count; ++i) names.emplace_back(fidelity_name(static_cast<Fidelity>(i)));
  return names;
}

/// The words that an option takes: those that are in lists of the program, and the few that are not.
void add_values(const std::string& command, OptionInfo& option) {
  const std::string& name = option.names.at(0);
  const auto take = [&option](Argument argument, std::vector<std::string> values) {
    option.argument = argument;
    option.values = std::move(values);
  };
  if (name == "--fidelity" && command == "bench") {
    std::vector<std::string> modes = fidelities();
    modes.insert(modes.begin(), "golden");
    take(Argument::list, modes);
  } else if (name == "--fidelity" && command == "scaling") {
    take(Argument::value, {"analytic", "event", "clocked"});
  } else if (name == "--fidelity") {
    take(Argument::value, fidelities());
  } else if (name == "--pictures") {
    std::vector<std::string> names(std::begin(picture_names), std::end(picture_names));
    names.insert(names.end(), {"all", "none"});
    take(Argument::list, names);
  } else if (name == "--policies") {
    std::vector<std::string> names;
    for (const Policy& policy : all_policies()) names.push_back(policy.name);
    take(Argument::list, names);
  } else if (name == "--trees") {
    take(Argument::list, {"bvh2", "bvh4", "bvh8", "kd"});
  } else if (name == "--memory-trace-format") {
    take(Argument::value, {"dramsim3", "ramulator", "ramulator2"});
  } else if (name == "--backend") {
    take(Argument::value, {"local", "slurm"});
  } else if (name == "--frames") {
    option.values = {"all"};
  } else if (name == "--inject-fault") {
    take(Argument::value, {"box", "triangle", "shading", "interpolation", "threshold", "dram"});
  }
}

Argument argument_of(const std::string& placeholder) {
  if (placeholder.empty()) return Argument::none;
  if (placeholder == "DIR") return Argument::folder;
  if (placeholder.compare(0, 4, "FILE") == 0) return Argument::file;
  if (placeholder == "path=value" || placeholder == "PARAMETER=VALUE,...") return Argument::parameter;
  return Argument::other;
}

OptionInfo describe(const CLI::Option& option, const std::string& command) {
  OptionInfo info;
  for (const std::string& name : option.get_lnames()) info.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) info.names.push_back("-" + name);
  if (option.get_expected_max() != 0 && option.get_type_size() != 0) info.placeholder = option.get_option_text();
  info.text = option.get_description();
  info.group = option.get_group();
  info.argument = argument_of(info.placeholder);
  add_values(command, info);
  return info;
}

}  // namespace

std::vector<CommandInfo> describe_commands(const CLI::App& app) {
  std::vector<CommandInfo> commands;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    CommandInfo command{sub->get_name(), sub->get_description(), sub->get_group(), {}, {}, {}, {}, sub->get_footer()};
    for (const CLI::Option* option : sub->get_options()) {
      if (option->nonpositional()) {
        command.options.push_back(describe(*option, command.name));
        continue;
      }
      const std::string name = option->get_name(true, false);
      const std::string more = option->get_expected_max() > 1 ? "..." : "";
      command.positionals.push_back(option->get_required() ? name + more : "[" + name + more + "]");
      command.positional_texts.push_back(option->get_description());
      if (name == "SHELL") command.positional_values = {"bash", "zsh", "fish"};
    }
    commands.push_back(std::move(command));
  }
  return commands;
}

std::vector<ParameterWords> parameter_words() {
  std::vector<ParameterWords> words;
  for (const ParameterInfo& parameter : parameter_list()) {
    const std::string& value = parameter.default_value;
    const bool named = value.front() == '"' || value == "true" || value == "false";
    words.push_back({parameter.path, named ? split(parameter.range) : std::vector<std::string>()});
  }
  return words;
}

}  // namespace artu::sim
