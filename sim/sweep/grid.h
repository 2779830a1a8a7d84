// GRID.toml: what a sweep varies, on which scenes (docs/sweep.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/command/frame_source.h"
#include "sim/command/options.h"
#include "sim/config/configuration.h"
#include "sim/sweep/axis.h"

namespace artu::sim {

enum class Design : std::uint8_t { grid, list, latin_hypercube, sobol, search };

/// "grid", "list" ... as in sweep.json.
const char* design_name(Design design);

/// What is to be small, or large: a column of the table, or a parameter that is varied.
struct Objective {
  std::string figure;
  bool maximise = false;
};

/// All points with a cheap fidelity first, then those that are not dominated with the grid's own.
struct Screen {
  Fidelity fidelity = Fidelity::analytic;
  double margin = 0;  // a point stays unless another is better than it by more than this share in every objective
};

struct Grid {
  std::string file;
  std::vector<SourceOptions> scenes;      // paths from the working directory
  std::vector<std::string> scene_files;   // as written
  std::vector<std::string> scene_names;   // the same; of a file that is there more than once, with what differs
  std::vector<std::string> config_files;  // the same
  std::vector<std::string> assignments;   // path=value, after the files
  Configuration base;                     // files and assignments
  SimulationOptions simulation;           // fidelity, seed and fault
  std::string fault_words;                // as on the command line; "" = none
  SampleSize sample;                      // with `sampled`
  std::vector<std::string> sample_words;  // as on the command line
  std::optional<PictureSet> pictures;     // none given: as `artu run`
  std::string picture_words;              // as on the command line
  std::vector<Objective> objectives;
  std::optional<Screen> screen;
  bool skip_invalid = false;  // combinations that the unit refuses are rows, not errors
  Design design = Design::grid;
  std::uint32_t samples = 0;                     // of latin_hypercube, sobol, search
  std::uint64_t seed = 0;                        // the same
  std::uint32_t batch = 0;                       // of search: points that are chosen together
  std::vector<Axis> axes;                        // in the order of the file
  std::vector<std::vector<std::string>> listed;  // of list: a value an axis, a row a point
  std::vector<std::string> listed_places;        // FILE:LINE of each row
};

/// Throws InputError with FILE:LINE.
Grid read_grid(const std::string& file);

/// [[point]] tables of a file that gives the points of a search; each gives every axis.
std::vector<std::vector<std::string>> read_points(const std::string& file, const Grid& grid);

}  // namespace artu::sim
