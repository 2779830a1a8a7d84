// The plot of `artu reuse`: above the miss-ratio curves, below the working sets.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sim/report/gnuplot.h"
#include "sim/reuse/reuse_report.h"

namespace artu::sim {

namespace {

double kib(double lines) { return lines * hw::line_bytes / 1024; }

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

bool drawn(const CacheReuse& kind) { return kind.requests != 0; }

}  // namespace

/// gnuplot's blocks, two blank lines apart: a curve for each cache that is used, their sizes, a working set for each.
std::string reuse_data(const std::vector<CacheReuse>& kinds, const std::vector<ModelMisses>& model) {
  std::string out;
  for (const CacheReuse& k : kinds) {
    if (!drawn(k)) continue;
    out += fmt::format("# {}: KiB, misses in percent with the least recently used line replaced\n", k.name);
    for (const std::uint64_t size : sizes_of_curve(k)) {
      out += fmt::format("{:.6g} {:.6g}\n", kib(static_cast<double>(size)), percent(k.misses(size), k.requests));
    }
    out += "\n\n";
  }
  out += "# as configured: KiB, misses in percent of the model, cache\n";
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (!drawn(kinds[i])) continue;
    out += fmt::format("{:.6g} {:.6g} \"{}\"\n", kib(static_cast<double>(kinds[i].lines)),
                       percent(model[i].misses, model[i].requests), kinds[i].name);
  }
  for (const CacheReuse& k : kinds) {
    if (!drawn(k)) continue;
    out += fmt::format("\n\n# {}: window, working set in KiB, mean of the caches\n", k.name);
    std::uint64_t number = 0;
    for (const WorkingSet& set : k.windows) {
      // A logarithmic axis has no place for 0: the line is broken where the cache is not used.
      out += set.lines > 0 ? fmt::format("{} {:.6g}\n", number, kib(set.lines)) : fmt::format("{} NaN\n", number);
      ++number;
    }
  }
  return out;
}

std::string reuse_script(const std::vector<CacheReuse>& kinds, const std::string& title, std::uint64_t window) {
  static constexpr const char* colors[] = {"#1f77b4", "#2ca02c", "#ff7f0e", "#9467bd", "#d62728"};
  std::string curves, sets;
  std::size_t number = 0;
  const auto count = static_cast<std::size_t>(std::count_if(kinds.begin(), kinds.end(), drawn));
  for (const CacheReuse& k : kinds) {
    if (!drawn(k)) continue;
    const char* color = colors[number % std::size(colors)];
    const std::string name = gnuplot_literal(k.name);
    curves += fmt::format(
        "data index {} using 1:2 with steps linewidth 1.5 linecolor rgb '{}' title {} noenhanced, \\\n     ", number,
        color, name);
    curves += fmt::format(
        "data index {} every ::{}::{} using 1:2 with points pointtype 7 linecolor rgb '{}' notitle, \\\n     ", count,
        number, number, color);
    sets += fmt::format("{}data index {} using 1:2 with lines linewidth 1.5 linecolor rgb '{}' title {} noenhanced",
                        number == 0 ? "" : ", \\\n     ", count + 1 + number, color, name);
    ++number;
  }
  curves += "NaN with points pointtype 7 linecolor rgb '#7f7f7f' title 'as configured, of the model'";
  return fmt::format(
      "# Misses by size of cache, and working sets; draw again with: gnuplot {0}.gnuplot\n"
      "data = '{0}.dat'\n"
      "do for [kind in 'svg png'] {{\n"
      "if (kind eq 'svg') {{ set terminal svg size 800,900 font 'sans-serif,12' background 'white' }} \\\n"
      "else {{ set terminal pngcairo size 800,900 font 'Sans,11' }}\n"
      "set output '{0}.' . kind\n"
      "set multiplot layout 2,1 title {1} noenhanced\n"
      "set grid linecolor rgb '#e4e4e4'\n"
      "set key below\n"
      "set logscale x 2\n"
      "set xlabel 'size of a cache, KiB'\n"
      "set ylabel 'misses, % of the requests'\n"
      "set yrange [0:*]\n"
      "plot {2}\n"
      "unset logscale x\n"
      "set logscale y 2\n"
      "set autoscale\n"
      "set xlabel 'time, windows of {3} cycles'\n"
      "set ylabel 'working set of a cache, KiB'\n"
      "plot {4}\n"
      "unset logscale y\n"
      "unset multiplot\n"
      "unset output\n"
      "}}\n",
      reuse_plot, gnuplot_literal(title), curves, window, sets);
}

}  // namespace artu::sim
