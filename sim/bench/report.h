// The outcome of `artu bench` as text, CSV, JSON and a plot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/bench/growth.h"
#include "sim/bench/measure.h"
#include "sim/report/gnuplot.h"

namespace artu::sim {

/// Of bench.json's layout: changes when a name that exists changes its meaning or goes.
inline constexpr int bench_schema = 1;

struct BenchScene {
  std::string name;
  std::uint64_t triangles = 0;
  std::uint32_t width = 0, height = 0, frame = 0;
  std::vector<ModeResult> results;

  /// The median time over another mode's; nothing where one of the two was not measured.
  std::optional<double> ratio(const ModeResult& result, const std::string& to) const;
  /// Cycles over those of `event`, less 1.
  std::optional<double> error(const ModeResult& result) const;
  /// Whether the cycles of `event` lie in the interval.
  std::optional<bool> covered(const ModeResult& result) const;
};

/// A mode over all scenes.
struct ModeSummary {
  std::string mode;
  std::size_t scenes = 0;
  std::optional<double> golden_median, golden_worst;  // times the golden model's time
  std::optional<double> functional_median, functional_worst, event_median;
  std::optional<double> mean_error, worst_error;  // of the magnitudes
  std::optional<double> covered;                  // share of the intervals that have the true value
};
std::vector<ModeSummary> summaries(const std::vector<BenchScene>& scenes, const std::vector<std::string>& modes);

struct BenchReport {
  BenchPlan plan;
  std::vector<BenchScene> scenes;
  std::vector<Growth> growth;
};

/// A table a scene, then one over all scenes, then what grows; at most 120 columns.
std::string format_bench(const BenchReport& report);
/// bench.csv: a row a scene and mode.  growth.csv: a row a point and mode.
std::string bench_csv(const BenchReport& report);
std::string growth_csv(const BenchReport& report);
std::string bench_json(const BenchReport& report, const std::vector<std::string>& command, const std::string& version);
/// Run time against error: a point a scene and mode, modes that are exact on the axis.
Plot bench_plot(const BenchReport& report);

}  // namespace artu::sim
