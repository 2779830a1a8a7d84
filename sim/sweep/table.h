// The table of a sweep: a row a point, in the order of the points, from what their folders hold.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/sweep/figures.h"
#include "sim/sweep/plan.h"
#include "sim/sweep/sweep_folder.h"

namespace artu::sim {

/// `ok`; `dead-lock`; `violated`: an accounting law is, the folder has all figures; `refused`: the unit cannot be
/// configured so, or the scene does not fit; `internal`: an error of the model; `pending`: not simulated yet.
struct SweepResult {
  std::uint32_t point = 0;
  std::string status;
  Figures figures;
};

/// What error.json holds of a point that has no report.
std::string error_json(const std::string& status, const std::string& message);

SweepResult result_of(const SweepFolder& folder, const SweepPoint& point);
std::vector<SweepResult> results_of(const SweepFolder& folder, const std::vector<SweepPoint>& points);

/// Column names and rows; an empty cell is null.
struct SweepTable {
  std::vector<std::string> columns;
  std::vector<std::vector<nlohmann::ordered_json>> rows;
};

/// point, folder, scene, frames, size, fidelity, status; the varied parameters by their paths; with a screen
/// `confirms`; the figures.
SweepTable table_of(const Grid& grid, const std::vector<SweepPoint>& points, const std::vector<SweepResult>& results);

/// As RFC 4180.
std::string csv_of(const SweepTable& table);

/// Replaces points.csv and points.sqlite: tables `points`, as the CSV, and `counters` (point, block, counter, value).
void write_tables(const SweepFolder& folder, const SweepTable& table, const std::vector<SweepPoint>& points);

}  // namespace artu::sim
