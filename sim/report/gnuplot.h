// Plots, drawn by gnuplot where it is installed.
#pragma once

#include <string>

namespace artu::sim {

/// A script and the data it reads.  The script draws NAME.svg and NAME.png.
struct Plot {
  std::string name, data, script;

  std::string data_file() const { return name + ".dat"; }
  std::string script_file() const { return name + ".gnuplot"; }
};

/// Writes script and data into `folder` and draws.  "" if all went well, else why there is no picture; none is left
/// half drawn.  Throws InputError if the disk is full.
std::string draw_plot(const std::string& folder, const Plot& plot);

/// In `folder`, on the file `script` in it.  "" if all went well, else what went wrong.
std::string run_gnuplot(const std::string& folder, const std::string& script);

/// The text as a literal of a script, in single quotes.
std::string gnuplot_literal(const std::string& text);

}  // namespace artu::sim
