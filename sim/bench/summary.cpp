#include <algorithm>
#include <cmath>

#include "sim/bench/report.h"

namespace artu::sim {
namespace {

/// What the scenes give, each of which may have nothing.
template <class Figure>
std::vector<double> all(const std::vector<BenchScene>& scenes, const std::string& mode, Figure figure) {
  std::vector<double> values;
  for (const BenchScene& scene : scenes) {
    const ModeResult* result = find(scene.results, mode);
    if (result == nullptr) continue;
    if (const auto value = figure(scene, *result)) values.push_back(static_cast<double>(*value));
  }
  return values;
}

std::optional<double> mean(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

std::optional<double> at(const std::vector<double>& values, double share) {
  return values.empty() ? std::optional<double>() : quantile(values, share);
}

}  // namespace

std::optional<double> BenchScene::ratio(const ModeResult& result, const std::string& to) const {
  const ModeResult* other = find(results, to);
  if (other == nullptr || !(other->median() > 0)) return std::nullopt;
  return result.median() / other->median();
}

std::optional<double> BenchScene::error(const ModeResult& result) const {
  const ModeResult* exact = find(results, fidelity_name(Fidelity::event));
  if (exact == nullptr || !result.cycles || !(*exact->cycles > 0)) return std::nullopt;
  return *result.cycles / *exact->cycles - 1;
}

std::optional<bool> BenchScene::covered(const ModeResult& result) const {
  const ModeResult* exact = find(results, fidelity_name(Fidelity::event));
  if (exact == nullptr || !result.interval) return std::nullopt;
  return result.interval->low <= *exact->cycles && *exact->cycles <= result.interval->high;
}

std::vector<ModeSummary> summaries(const std::vector<BenchScene>& scenes, const std::vector<std::string>& modes) {
  std::vector<ModeSummary> rows;
  for (const std::string& mode : modes) {
    ModeSummary row;
    row.mode = mode;
    const auto ratios = [&](const char* to) {
      return all(scenes, mode, [to](const BenchScene& s, const ModeResult& r) { return s.ratio(r, to); });
    };
    row.scenes = all(scenes, mode, [](const BenchScene&, const ModeResult&) { return std::optional<int>(1); }).size();
    if (row.scenes == 0) continue;
    const std::vector<double> golden = ratios(golden_mode), functional = ratios(fidelity_name(Fidelity::functional));
    row.golden_median = at(golden, 0.5);
    row.golden_worst = at(golden, 1);
    row.functional_median = at(functional, 0.5);
    row.functional_worst = at(functional, 1);
    row.event_median = at(ratios(fidelity_name(Fidelity::event)), 0.5);
    std::vector<double> errors = all(scenes, mode, [](const BenchScene& s, const ModeResult& r) { return s.error(r); });
    for (double& error : errors) error = std::abs(error);
    row.mean_error = mean(errors);
    row.worst_error = at(errors, 1);
    row.covered = mean(all(scenes, mode, [](const BenchScene& s, const ModeResult& r) { return s.covered(r); }));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace artu::sim
