#include "sim/bench/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/bench/terrain.h"

namespace artu::sim {
namespace {

constexpr std::uint32_t core_counts[] = {1, 2, 4, 8, 16};

PowerLaw law_of(const Growth& growth, const std::string& mode, const std::function<double(const ModeResult&)>& figure) {
  std::vector<double> x, y;
  for (const GrowthPoint& point : growth.points) {
    const ModeResult* result = find(point.results, mode);
    const double value = result != nullptr ? figure(*result) : 0;
    if (!(value > 0)) return {0, std::numeric_limits<double>::quiet_NaN()};
    x.push_back(static_cast<double>(point.value));
    y.push_back(value);
  }
  if (x.size() < 2) return {0, std::numeric_limits<double>::quiet_NaN()};
  return fit_power_law(x, y);
}

/// The golden model knows no cores.
Growth grow_core_count(const GrowthPlan& plan, const GrowthPlan::Loaded& loaded, hw::UnitConfig unit,
                       std::vector<std::string>& notes) {
  Growth growth;
  BenchPlan bench = plan.bench;
  bench.modes.erase(std::remove(bench.modes.begin(), bench.modes.end(), golden_mode), bench.modes.end());
  for (const std::uint32_t count : core_counts) {
    unit.core.count = count;
    growth.points.push_back({count, measure({loaded.scene, loaded.frame, unit}, bench, notes)});
  }
  return growth;
}

}  // namespace

PowerLaw fit_power_law(const std::vector<double>& x, const std::vector<double>& y) {
  double mean_x = 0, mean_y = 0, products = 0, squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / static_cast<double>(x.size());
    mean_y += std::log(y[i]) / static_cast<double>(x.size());
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    products += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
    squares += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
  }
  const double exponent = products / squares;
  return {std::exp(mean_y - exponent * mean_x), exponent};
}

PowerLaw Growth::time(const std::string& mode) const {
  return law_of(*this, mode, [](const ModeResult& r) { return r.median(); });
}

PowerLaw Growth::memory(const std::string& mode) const {
  return law_of(*this, mode, [](const ModeResult& r) { return static_cast<double>(r.peak_bytes); });
}

Growth grow_pixels(const GrowthPlan& plan, std::vector<std::string>& notes) {
  Growth growth;
  growth.what = "pixels";
  growth.of = plan.scene;
  for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    const auto scaled = [&](std::uint32_t edge) {
      return static_cast<std::uint32_t>(std::max(1L, std::lround(edge * std::sqrt(factor))));
    };
    const GrowthPlan::Loaded loaded = plan.load(scaled(plan.width), scaled(plan.height));
    growth.points.push_back({std::uint64_t{loaded.scene.width} * loaded.scene.height,
                             measure({loaded.scene, loaded.frame, plan.unit}, plan.bench, notes)});
  }
  return growth;
}

Growth grow_triangles(const GrowthPlan& plan, std::vector<std::string>& notes) {
  Growth growth;
  growth.what = "triangles";
  growth.of = fmt::format("a terrain, {}x{}", plan.width, plan.height);
  for (const std::uint32_t edge : {16u, 32u, 64u, 128u, 256u}) {
    const traces::Scene scene = terrain(edge, plan.width, plan.height);
    const traces::Frame frame = terrain_frame(plan.width, plan.height);
    growth.points.push_back(
        {scene.static_geometry.triangle_count(), measure({scene, frame, plan.unit}, plan.bench, notes)});
  }
  return growth;
}

Growth grow_cores(const GrowthPlan& plan, std::vector<std::string>& notes) {
  Growth growth = grow_core_count(plan, plan.load(plan.width, plan.height), plan.unit, notes);
  growth.what = "cores";
  growth.of = fmt::format("{}, {}x{}", plan.scene, plan.width, plan.height);
  return growth;
}

Growth grow_idle_cores(const GrowthPlan& plan, std::vector<std::string>& notes) {
  hw::UnitConfig unit = plan.unit;
  unit.core.dispatch = hw::Dispatch::tiles;
  unit.selective.tile = 256;
  const std::uint32_t width = std::min(plan.width, unit.selective.tile);
  const std::uint32_t height = std::min(plan.height, unit.selective.tile);
  Growth growth = grow_core_count(plan, plan.load(width, height), unit, notes);
  growth.what = "idle cores";
  growth.of = fmt::format("{}, {}x{}, one core has all the work", plan.scene, width, height);
  return growth;
}

}  // namespace artu::sim
