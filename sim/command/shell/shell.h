// Completion of the command line in a shell, and its manual page.
#pragma once

#include <string>
#include <vector>

#include "sim/command/shell/model.h"

namespace artu::sim {

/// For `source <(artu completion bash)`, or a file in bash-completion's folder.
std::string bash_completion(const std::vector<CommandInfo>& commands);
/// A function for a folder of zsh's `fpath`, as `_artu`.
std::string zsh_completion(const std::vector<CommandInfo>& commands);
/// A file for fish's `vendor_completions.d`.
std::string fish_completion(const std::vector<CommandInfo>& commands);

/// artu(1), for man(1): macros of man(7).
std::string manual_page(const std::vector<CommandInfo>& commands);

}  // namespace artu::sim
