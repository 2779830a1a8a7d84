#include <fmt/format.h>

#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"
#include "sim/command/shell/shell.h"

namespace artu::sim {
namespace {

/// They print what is declared here, so they need all of it.
struct ShellOptions {
  const CLI::App* app = nullptr;
  std::string shell;
};

int completion(const ShellOptions& options) {
  const std::vector<CommandInfo> commands = describe_commands(*options.app);
  fmt::print("{}", options.shell == "bash"  ? bash_completion(commands)
                   : options.shell == "zsh" ? zsh_completion(commands)
                                            : fish_completion(commands));
  return exit_fine;
}

int manual(const ShellOptions& options) {
  fmt::print("{}", manual_page(describe_commands(*options.app)));
  return exit_fine;
}

}  // namespace

void add_completion(CommandLine& line) {
  const auto options = std::make_shared<ShellOptions>();
  options->app = &line.app;
  CLI::App& command = add_command(
      line, "completion", "Print what makes a shell complete commands, options and parameters", options, completion);
  command.add_option("SHELL", options->shell, "bash, zsh or fish")
      ->option_text(" ")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  add_examples(command, {{"artu completion bash > ~/.local/share/bash-completion/completions/artu", "for good"},
                         {"artu completion fish > ~/.config/fish/completions/artu.fish", "for fish"}});
}

void add_man(CommandLine& line) {
  const auto options = std::make_shared<ShellOptions>();
  options->app = &line.app;
  CLI::App& command = add_command(line, "man", "Print the manual page, for man(1)", options, manual);
  add_examples(command, {{"artu man > artu.1 && man -l artu.1", "to read it"}});
}

}  // namespace artu::sim
