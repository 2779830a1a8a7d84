// Runs gnuplot, where it is installed.
#pragma once

#include <string>

namespace artu::sim {

/// In `folder`, on the file `script` in it.  "" if all went well, else what went wrong.
std::string run_gnuplot(const std::string& folder, const std::string& script);

/// The text as a literal of a script, in single quotes.
std::string gnuplot_literal(const std::string& text);

}  // namespace artu::sim
