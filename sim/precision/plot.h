// The plot "cost against error": cycles of each tree over the error of each format, for gnuplot.
#pragma once

#include <string>
#include <vector>

#include "sim/precision/sweep.h"

namespace artu::sim {

inline constexpr const char* precision_plot = "cost-against-error";  // the name of its files

/// A block of lines a tree; the first line names the columns.
std::string plot_data(const std::vector<SweepRow>& rows, std::uint32_t frames);

/// Draws the data file beside it as cost-against-error.svg and .png.  `title` says what was rendered.  "" where nothing
/// can be drawn: no picture differs, or they are too small for SSIM.
std::string plot_script(const std::vector<SweepRow>& rows, std::uint32_t frames, const std::string& title);

}  // namespace artu::sim
