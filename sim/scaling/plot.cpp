// The plot of `artu scaling`: what is gained, and which resource takes it.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sim/report/gnuplot.h"
#include "sim/scaling/scaling.h"

namespace artu::sim {

namespace {
constexpr std::size_t drawn[] = {0, 1, 5, 6, 8};  // of the demands

}  // namespace

std::string scaling_data(const std::vector<ScalingRow>& rows) {
  std::string out = "# value, speed-up, demands in percent, contexts filled in percent, what limits\n";
  for (const ScalingRow& row : rows) {
    out += fmt::format("\"{}\" {:.6g}", row.value, row.speedup);
    for (const std::size_t i : drawn) out += fmt::format(" {:.6g}", 100 * row.demands[i].share);
    out += fmt::format(" {:.6g} \"{}\"\n", 100 * row.contexts, row.limit);
  }
  return out;
}

std::string scaling_script(const Variation& variation, const std::vector<ScalingRow>& rows, const std::string& title) {
  double best = 1;
  for (const ScalingRow& row : rows) best = std::max(best, row.speedup);
  std::string lines;
  for (std::size_t i = 0; i < std::size(drawn); ++i) {
    lines += fmt::format("data using 0:{}:xtic(1) with linespoints linestyle {} title '{}', \\\n     ", i + 3, i + 2,
                         rows.at(0).demands[drawn[i]].resource);
  }
  lines += fmt::format("data using 0:{}:xtic(1) with linespoints linestyle 7 dashtype 3 title 'contexts filled'",
                       std::size(drawn) + 3);
  return fmt::format(
      "# What a parameter gains, and what limits it; draw again with: gnuplot {0}.gnuplot\n"
      "data = '{0}.dat'\n"
      "set grid ytics linecolor rgb '#e4e4e4'\n"
      "set xrange [-0.4:{1}.4]\n"
      "set style line 1 linecolor rgb '#1f77b4' linewidth 2 pointtype 7\n"
      "set style line 2 linecolor rgb '#2ca02c' linewidth 1.5 pointtype 5\n"
      "set style line 3 linecolor rgb '#ff7f0e' linewidth 1.5 pointtype 9\n"
      "set style line 4 linecolor rgb '#9467bd' linewidth 1.5 pointtype 11\n"
      "set style line 5 linecolor rgb '#d62728' linewidth 1.5 pointtype 13\n"
      "set style line 6 linecolor rgb '#8c564b' linewidth 1.5 pointtype 4\n"
      "set style line 7 linecolor rgb '#7f7f7f' linewidth 1.5 pointtype 6\n"
      "do for [kind in 'svg png'] {{\n"
      "if (kind eq 'svg') {{ set terminal svg size 720,720 font 'sans-serif,12' background 'white' }} \\\n"
      "else {{ set terminal pngcairo size 720,720 font 'Sans,11' }}\n"
      "set output 'scaling.' . kind\n"
      "set multiplot layout 2,1 title {2} noenhanced\n"
      "unset key\n"
      "set ylabel 'speed-up'\n"
      "set yrange [0:{6:.4g}]\n"
      "plot data using 0:2:xtic(1) with linespoints linestyle 1, \\\n"
      "     data using 0:2:{3} with labels font ',9' offset 0,0.9 noenhanced\n"
      "set key below\n"
      "set xlabel {4} noenhanced\n"
      "set ylabel 'demand, % of what there is'\n"
      "set yrange [0:105]\n"
      "plot {5}\n"
      "unset xlabel\n"
      "unset multiplot\n"
      "unset output\n"
      "}}\n",
      scaling_plot, rows.size() - 1, gnuplot_literal(title), std::size(drawn) + 4, gnuplot_literal(variation.parameter),
      lines, 1.15 * best);
}

}  // namespace artu::sim
