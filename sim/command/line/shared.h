// Options that several commands have, and what every command's options need.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/command/commands.h"
#include "sim/command/ranges.h"

namespace artu::sim {

/// Where the options of a command are declared, and what then runs it.
struct CommandLine {
  CLI::App& app;
  std::function<int()> chosen;     // the command that was named
  std::vector<std::string> words;  // of the command line
};

/// Declares a command; `options` are its values, which live as long as the command line.
template <class Options>
CLI::App& add_command(CommandLine& line, const char* name, const char* what, std::shared_ptr<Options> options,
                      int (*run)(const Options&)) {
  CLI::App& command = *line.app.add_subcommand(name, what);
  command.callback([&line, options, run] { line.chosen = [options, run] { return run(*options); }; });
  return command;
}

/// A command line to copy, and what it does.
struct Example {
  const char* words;
  const char* what;
};

/// "Examples:" and a line each.
std::string format_examples(const std::vector<Example>& examples);

/// The end of a command's help; every command has one.
void add_examples(CLI::App& command, const std::vector<Example>& examples);

/// Scene or trace, frames, size and frames per second.
void add_source(CLI::App& command, SourceOptions& source, const char* size, bool scene_only, bool required);

/// The same without the scene or trace itself.
void add_frames(CLI::App& command, SourceOptions& source, const char* size);

void add_jobs(CLI::App& command, std::uint32_t& jobs);

/// `given` is told of the option that was.
void add_sample_size(CLI::App& command, SampleSize& size, const std::function<void(const char*)>& given);

void add_pictures(CLI::App& command, const char* by_default, const std::function<void(const PictureSet&)>& take);

/// -c and --set, of Options with `config_files` and `assignments`.
template <class Options>
void add_configuration(CLI::App& command, Options& options) {
  command.add_option("-c,--config", options.config_files, "Configuration, TOML; may be repeated, the last one wins")
      ->option_text("FILE")
      ->allow_extra_args(false)
      ->group("Configuration");
  command.add_option("--set", options.assignments, "Set one parameter, after all files; may be repeated")
      ->option_text("path=value")
      ->allow_extra_args(false)
      ->group("Configuration");
}

/// -o, --force and --quiet, of Options with `output`, `force` and `quiet`.
template <class Options>
void add_report(CLI::App& command, Options& options, const char* quiet) {
  command.add_option("-o,--output", options.output, "Folder of the report")->option_text("DIR")->group("Output");
  command.add_flag("--force", options.force, "Replace an earlier run's folder")->group("Output");
  command.add_flag("--quiet", options.quiet, quiet)->group("Output");
}

}  // namespace artu::sim
