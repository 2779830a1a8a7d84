#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "sim/quality/front.h"
#include "sim/quality/report.h"

namespace artu::sim {
namespace {

constexpr const char* colors[] = {"#7f7f7f", "#2ca02c", "#1f77b4", "#d62728", "#9467bd", "#ff7f0e", "#8c564b"};

/// Columns of the data file from 1 on: cycles, rays, DRAM bytes, energy, PSNR of the areas, FLIP.
struct Panel {
  const char* title;
  int cost, error;
  const char* cost_label;
  const char* error_label;
};
constexpr Panel panels[] = {
    {"whole frame", 1, 5, "cycles a frame, in thousands", "PSNR, dB"},
    {"dynamic geometry", 1, 6, "cycles a frame, in thousands", "PSNR, dB"},
    {"whole frame, FLIP", 1, 9, "cycles a frame, in thousands", "FLIP"},
    {"whole frame", 2, 5, "rays a frame, in thousands", "PSNR, dB"},
    {"whole frame", 3, 5, "DRAM MB a frame", "PSNR, dB"},
    {"whole frame", 4, 5, "energy a frame, uJ", "PSNR, dB"},
};

/// Cycles, rays, DRAM bytes and energy of a frame, as in the data file; NaN where there is none.
std::array<double, 4> costs_of(const QualityRow& row, std::uint32_t frames) {
  const auto cost = [&](auto sum, double unit) {
    return sum ? static_cast<double>(*sum) / frames / unit : std::numeric_limits<double>::quiet_NaN();
  };
  return {cost(row.cycles, 1e3), static_cast<double>(row.rays) / frames / 1e3, cost(row.dram_bytes, 1e6),
          cost(row.picojoules, 1e6)};
}

/// The range of a cost's axis, and a line where the full render lies.
std::string cost_axis(const std::vector<QualityRow>& rows, std::uint32_t frames, int column) {
  double lo = std::numeric_limits<double>::infinity(), hi = 0, full = 0;
  for (const QualityRow& row : rows) {
    const double cost = costs_of(row, frames)[static_cast<std::size_t>(column) - 1];
    if (std::isnan(cost)) continue;
    lo = std::min(lo, cost);
    hi = std::max(hi, cost);
    if (row.policy == "full") full = cost;
  }
  const double margin = 0.08 * std::max(hi - lo, 0.01 * hi);
  return fmt::format(
      "set xrange [{:.6g}:{:.6g}]\n"
      "set arrow 1 from {:.6g}, graph 0 to {:.6g}, graph 1 nohead dashtype 3 linecolor rgb 'black'\n"
      "set label 1 'full' at {:.6g}, graph 0.06 right offset -0.4,0 font ',9'\n",
      lo - margin, hi + margin, full, full, full);
}

std::string data_line(const QualityRow& row, std::uint32_t frames) {
  const auto [cycles, rays, dram, energy] = costs_of(row, frames);
  std::string text = fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}", cycles, rays, dram, energy);
  for (const AreaError& area : row.errors.areas) {
    text += fmt::format(" {:.6g}", std::isfinite(area.psnr()) ? area.psnr() : std::nan(""));
  }
  return text + fmt::format(" {:.6g} \"{}\"\n", row.errors.of(Area::whole).mean_flip(),
                            row.reference ? fmt::format("{}", *row.reference) : row.policy);
}

std::string data_of(const std::vector<QualityRow>& rows, std::uint32_t frames) {
  std::string text =
      "# cycles, rays (thousands), DRAM MB, energy uJ, PSNR all, dynamic, static, background, FLIP, reference\n"
      "# computed, not simulated\n";
  for (const QualityRow& row : rows) {
    if (!row.reference && row.policy != "full") text += data_line(row, frames);
  }
  for (const std::string& policy : policies_of(rows)) {
    text += fmt::format("\n\n# {}\n", policy);
    for (const QualityRow& row : rows) {
      if (row.reference && row.policy == policy) text += data_line(row, frames);
    }
  }
  return text;
}

/// Whether a point has the panel's error: without dynamic geometry, or without an error, there is nothing to draw.
bool has_values(const std::vector<QualityRow>& rows, const Panel& panel) {
  return panel.error == 9 || std::any_of(rows.begin(), rows.end(), [&](const QualityRow& row) {
           return row.reference && std::isfinite(row.errors.areas[static_cast<std::size_t>(panel.error) - 5].psnr());
         });
}

}  // namespace

Plot quality_plot(const std::vector<QualityRow>& rows, std::uint32_t frames, const std::string& title) {
  const std::vector<std::string> policies = policies_of(rows);
  std::string styles, body;
  for (std::size_t i = 0; i < policies.size(); ++i) {
    styles += fmt::format("set style line {} linecolor rgb '{}' linewidth 1.5 pointtype {} pointsize 0.7\n", i + 1,
                          colors[i % std::size(colors)], 5 + 2 * (i % 5));
  }
  int drawn = 0;
  for (const Panel& panel : panels) {
    if (!has_values(rows, panel)) continue;
    ++drawn;
    body += cost_axis(rows, frames, panel.cost);
    body += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\nplot ", gnuplot_literal(panel.title),
                        gnuplot_literal(panel.cost_label), gnuplot_literal(panel.error_label));
    for (std::size_t i = 0; i < policies.size(); ++i) {
      body += fmt::format("data index {0} using {1}:{2} with linespoints linestyle {0} title {3} noenhanced, \\\n     ",
                          i + 1, panel.cost, panel.error, gnuplot_literal(policies[i]));
    }
    if (panel.cost == 2) {  // what the baselines have of the costs
      body += fmt::format(
          "data index 0 using {0}:{1} with points pointtype 2 linecolor rgb 'black' notitle, \\\n"
          "     data index 0 using {0}:{1}:10 with labels left font ',9' offset 0.7,0 noenhanced notitle, \\\n     ",
          panel.cost, panel.error);
    }
    body += fmt::format("data index 1 using {}:{}:10 with labels font ',8' offset 0,-0.8 notitle\nunset key\n",
                        panel.cost, panel.error);
  }
  Plot plot{"quality", data_of(rows, frames), ""};
  plot.script = fmt::format(
      "# Cost against error; draw again with: gnuplot {0}\n"
      "data = '{1}'\n"
      "set grid xtics ytics linecolor rgb '#e4e4e4'\n"
      "set datafile missing 'nan'\n"
      "set bmargin 5\n"
      "set xtics rotate by -30 font ',9'\n"
      "set offsets 0, 0, graph 0.08, graph 0.08\n"
      "{2}"
      "do for [kind in 'svg png'] {{\n"
      "if (kind eq 'svg') {{ set terminal svg size 1260,{6} font 'sans-serif,12' background 'white' }} \\\n"
      "else {{ set terminal pngcairo size 1260,{6} font 'Sans,10' }}\n"
      "set output 'quality.' . kind\n"
      "set multiplot layout {5},3 title {3} noenhanced\n"
      "set key at screen 0.5,0.02 center horizontal\n"
      "{4}"
      "unset multiplot\n"
      "unset output\n"
      "}}\n",
      plot.script_file(), plot.data_file(), styles,
      gnuplot_literal(title + "; numbers are the reference threshold of the first policy"), body, (drawn + 2) / 3,
      60 + 350 * ((drawn + 2) / 3));
  return plot;
}

}  // namespace artu::sim
