// The outcome of `artu quality` as text, CSV, JSON and a plot.
#pragma once

#include <string>
#include <vector>

#include "sim/quality/sweep.h"
#include "sim/report/gnuplot.h"
#include "sim/report/manifest.h"

namespace artu::sim {

/// Of quality.json's layout: changes when a name that exists changes its meaning or goes.
inline constexpr int quality_schema = 1;

/// A row a policy and reference, at most 120 columns; counts are per frame.
std::string format_quality(const std::vector<QualityRow>& rows, std::uint32_t frames);
/// A row a traced share and policy: PSNR of each area, and how much more that is than the plain policy's.
std::string format_equal_shares(const std::vector<QualityRow>& rows, const std::vector<double>& shares);
/// Of the rows that are shown: which causes the squared error has, and the largest of what is held apart.
std::string format_attribution(const std::vector<QualityRow>& rows);

/// quality.csv, equal_shares.csv, attribution.csv and worst_pixels.csv, each with a line of names first.  Counts are
/// sums over the frames; "inf" is a PSNR without error, "nan" what is not defined, an empty cell what was not
/// simulated.
std::string quality_csv(const std::vector<QualityRow>& rows);
std::string equal_shares_csv(const std::vector<QualityRow>& rows, const std::vector<double>& shares);
std::string attribution_csv(const std::vector<QualityRow>& rows);
std::string worst_pixels_csv(const std::vector<QualityRow>& rows);

/// The first two with what was run; what is infinite, undefined or not simulated is null.
std::string quality_json(const std::vector<QualityRow>& rows, const std::vector<double>& shares,
                         const QualityPlan& plan, const Manifest& manifest);

/// quality.svg and .png: error over cycles, rays, DRAM bytes and energy, a line a policy.
Plot quality_plot(const std::vector<QualityRow>& rows, std::uint32_t frames, const std::string& title);

}  // namespace artu::sim
