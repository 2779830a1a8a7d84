#include <fmt/format.h>

#include <cmath>

#include "sim/bench/report.h"

namespace artu::sim {
namespace {

constexpr const char* nothing = "-";

/// With so many significant digits; a dash where there is none.
std::string number(const std::optional<double>& value, const char* format) {
  const double v = value.value_or(std::nan(""));
  return std::isfinite(v) ? fmt::format(fmt::runtime(format), v) : nothing;
}

std::optional<double> per_second(std::uint64_t count, const ModeResult& result, double unit) {
  if (count == 0 || !(result.median() > 0)) return std::nullopt;
  return static_cast<double>(count) / result.median() / unit;
}

std::optional<double> scaled(std::optional<double> value, double factor) {
  if (value) *value *= factor;
  return value;
}

std::string interval_text(const BenchScene& scene, const ModeResult& result) {
  const auto covered = scene.covered(result);
  if (!covered) return nothing;
  const double exact = *find(scene.results, fidelity_name(Fidelity::event))->cycles;
  return fmt::format("{:+.2f} {:+.2f}{}", 100 * (result.interval->low / exact - 1),
                     100 * (result.interval->high / exact - 1), *covered ? "" : " !");
}

std::string scene_table(const BenchScene& scene) {
  std::string out = fmt::format("{}, frame {}, {}x{}, {} triangles\n", scene.name, scene.frame, scene.width,
                                scene.height, scene.triangles);
  out += fmt::format("{:<11} {:>10} {:>6} {:>8} {:>8} {:>9} {:>9} {:>9} {:>7} {:>8}  {}\n", "mode", "ms", "+-%",
                     "/golden", "/funct.", "Mcycles/s", "krays/s", "Mnodes/s", "MB", "error%", "95% interval");
  for (const ModeResult& r : scene.results) {
    const std::optional<double> cycles =
        r.cycles && r.median() > 0 ? std::optional<double>(*r.cycles / r.median() / 1e6) : std::nullopt;
    out += fmt::format("{:<11} {:>10.4g} {:>6.1f} {:>8} {:>8} {:>9} {:>9} {:>9} {:>7.0f} {:>8}  {}\n", r.mode,
                       1e3 * r.median(), 100 * r.spread(), number(scene.ratio(r, golden_mode), "{:.2f}"),
                       number(scene.ratio(r, fidelity_name(Fidelity::functional)), "{:.2f}"), number(cycles, "{:.4g}"),
                       number(per_second(r.primary_rays, r, 1e3), "{:.4g}"),
                       number(per_second(r.node_visits, r, 1e6), "{:.4g}"), static_cast<double>(r.peak_bytes) / 1e6,
                       number(scaled(scene.error(r), 100), "{:+.2f}"), interval_text(scene, r));
  }
  return out;
}

std::string summary_table(const BenchReport& report) {
  std::string out =
      fmt::format("all scenes\n{:<11} {:>7} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>9} {:>8}\n", "mode", "scenes",
                  "/golden", "worst", "/funct.", "worst", "/event", "|error|%", "worst", "covered%");
  for (const ModeSummary& row : summaries(report.scenes, report.plan.modes)) {
    out += fmt::format("{:<11} {:>7} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>9} {:>8}\n", row.mode, row.scenes,
                       number(row.golden_median, "{:.2f}"), number(row.golden_worst, "{:.2f}"),
                       number(row.functional_median, "{:.2f}"), number(row.functional_worst, "{:.2f}"),
                       number(row.event_median, "{:.3f}"), number(scaled(row.mean_error, 100), "{:.2f}"),
                       number(scaled(row.worst_error, 100), "{:.2f}"), number(scaled(row.covered, 100), "{:.0f}"));
  }
  return out;
}

/// Time and memory of every point, the last over the first, and the exponent.
std::string growth_table(const BenchReport& report, const Growth& growth) {
  std::string out = fmt::format("{}: {}\n{:<14}", growth.what, growth.of, "mode");
  for (const GrowthPoint& point : growth.points) out += fmt::format(" {:>9}", point.value);
  out += fmt::format(" {:>10} {:>9}\n", "last/first", "exponent");
  const auto row = [&](const std::string& mode, const std::string& title, auto figure, const PowerLaw& law) {
    out += fmt::format("{:<14}", title);
    std::optional<double> first, last;
    for (const GrowthPoint& point : growth.points) {
      const ModeResult* r = find(point.results, mode);
      last = r == nullptr ? std::nullopt : std::optional<double>(figure(*r));
      if (&point == &growth.points.front()) first = last;
      out += fmt::format(" {:>9}", number(last, "{:.4g}"));
    }
    if (last && first) last = *last / *first;
    out += fmt::format(" {:>10} {:>9}\n", number(last, "{:.2f}"), number(law.exponent, "{:.2f}"));
  };
  for (const std::string& mode : report.plan.modes) {
    if (find(growth.points.at(0).results, mode) == nullptr) continue;
    const auto milliseconds = [](const ModeResult& r) { return 1e3 * r.median(); };
    const auto megabytes = [](const ModeResult& r) { return static_cast<double>(r.peak_bytes) / 1e6; };
    row(mode, mode + " ms", milliseconds, growth.time(mode));
    row(mode, "  MB", megabytes, growth.memory(mode));
  }
  return out;
}

}  // namespace

std::string format_bench(const BenchReport& report) {
  std::string out;
  for (const BenchScene& scene : report.scenes) out += scene_table(scene) + "\n";
  if (report.scenes.size() > 1) out += summary_table(report) + "\n";
  for (const Growth& growth : report.growth) out += growth_table(report, growth) + "\n";
  return out;
}

}  // namespace artu::sim
