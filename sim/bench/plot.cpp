#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/bench/report.h"

namespace artu::sim {
namespace {

constexpr double exact_at = 0.005;  // percent: where a logarithmic axis has what has no error

constexpr const char* colors[] = {"#7f7f7f", "#2ca02c", "#ff7f0e", "#9467bd", "#1f77b4", "#d62728"};

/// A block a mode, for gnuplot's `index`: run time over event's, |error| in percent, the scene.
std::string block_of(const BenchReport& report, const std::string& mode) {
  std::string out;
  for (const BenchScene& scene : report.scenes) {
    const ModeResult* r = find(scene.results, mode);
    if (r == nullptr) continue;
    const auto ratio = scene.ratio(*r, fidelity_name(Fidelity::event)), error = scene.error(*r);
    if (!ratio || !error) continue;
    out += fmt::format("{:.6g} {:.6g} \"{}\"\n", *ratio, std::max(100 * std::abs(*error), exact_at), scene.name);
  }
  return out;
}

}  // namespace

Plot bench_plot(const BenchReport& report) {
  Plot plot;
  plot.name = "bench";
  plot.data = "# run time over that of event, |error| of the cycles in percent, scene; a block a mode\n";
  std::string lines;
  std::size_t blocks = 0;
  for (std::size_t i = 0; i < report.plan.modes.size(); ++i) {
    const std::string block = block_of(report, report.plan.modes[i]);
    if (block.empty()) continue;
    plot.data += block + "\n\n";
    lines += fmt::format(
        "{}'bench.dat' index {} using 1:2 with points pointtype {} pointsize 1.1 linecolor rgb '{}' "
        "title '{}'",
        blocks == 0 ? "" : ", \\\n     ", blocks, 5 + 2 * (blocks % 5), colors[i % std::size(colors)],
        report.plan.modes[i]);
    ++blocks;
  }
  if (blocks == 0) return {};
  plot.script = fmt::format(
      "# Run time against error; draw again with: gnuplot bench.gnuplot\n"
      "set logscale xy\n"
      "set grid linecolor rgb '#e4e4e4'\n"
      "set xlabel 'run time, 1 = event'\n"
      "set ylabel 'error of the cycles, % ({} = exact)'\n"
      "set yrange [{}:*]\n"
      "set key below\n"
      "do for [kind in 'svg png'] {{\n"
      "if (kind eq 'svg') {{ set terminal svg size 640,440 font 'sans-serif,12' background 'white' }} \\\n"
      "else {{ set terminal pngcairo size 640,440 font 'Sans,11' }}\n"
      "set output 'bench.' . kind\n"
      "plot {}\n"
      "unset output\n"
      "}}\n",
      exact_at, exact_at / 2, lines);
  return plot;
}

}  // namespace artu::sim
