// Files that a run writes beside its folder: none may be what it reads, what it writes under another option, or in a
// folder that is made anew.
#pragma once

#include <string>

#include "sim/command/options.h"

namespace artu::sim {

/// Whether both name the same place, whatever way they go there; it need not exist.
bool is_same_place(const std::string& a, const std::string& b);

/// Throws InputError, before anything is simulated or written.
void check_output_places(const RunOptions& options);

/// Throws InputError if `output` is the input.
void refuse_input_as_output(const std::string& output, const std::string& input);

/// Throws InputError if `output` is in `folder`, which may have a file of that name; `right` is what may be there.
void refuse_within(const std::string& output, const std::string& folder, const std::string& right);

}  // namespace artu::sim
