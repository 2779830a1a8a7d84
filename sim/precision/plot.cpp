#include "sim/precision/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/precision/axis.h"
#include "sim/report/gnuplot.h"
#include "sim/report/names.h"

namespace artu::sim {
namespace {

using Rows = std::vector<SweepRow>;

double cost(const SweepRow& row, std::uint32_t frames) { return static_cast<double>(row.cycles) / frames / 1e3; }

/// 1 - SSIM; 0 is no place on a logarithmic axis and becomes NaN, which gnuplot leaves out.
double distance(const ImageError& error) {
  const double d = 1 - error.ssim();
  return d > 1e-12 ? d : std::nan("");
}

std::size_t tree_count(const Rows& rows) {
  std::size_t count = 1;
  for (std::size_t i = 1; i < rows.size(); ++i) count += rows[i].tree != rows[i - 1].tree;
  return count;
}

/// A plot of its own: the error against one of the two references.
struct Panel {
  const char* title;
  ImageError SweepRow::*error;
  int column;  // of the data file
};
constexpr Panel panels[] = {{"against binary64, every pixel traced", &SweepRow::from_binary64, 1},
                            {"against M = 23 with the same settings", &SweepRow::from_binary32, 2}};

/// All points of a format: the trees show the same picture, so they lie above each other.
struct Column {
  std::string name;
  double error, lowest, highest;
};

std::vector<Column> columns_of(const Rows& rows, const Panel& panel, std::uint32_t frames) {
  std::vector<Column> columns;
  for (const SweepRow& row : rows) {
    const double error = distance(row.*panel.error), y = cost(row, frames);
    if (std::isnan(error)) continue;
    const std::string name = format_name(row.format);
    const auto known = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
    if (known == columns.end()) {
      columns.push_back({name, error, y, y});
    } else {
      known->lowest = std::min(known->lowest, y);
      known->highest = std::max(known->highest, y);
    }
  }
  return columns;
}

PlotAxis error_axis(const std::vector<Column>& columns) {
  std::vector<double> values;
  for (const Column& c : columns) values.push_back(c.error);
  return PlotAxis(values);
}

PlotAxis cost_axis(const std::vector<Column>& columns) {
  std::vector<double> values;
  for (const Column& c : columns) values.insert(values.end(), {c.lowest, c.highest});
  return PlotAxis(values);
}

/// Those whose names have room: where formats make no difference, they would lie on each other.
std::vector<Column> labelled(std::vector<Column> columns) {
  if (columns.empty()) return columns;
  const PlotAxis axis = error_axis(columns);
  // 23 is the one that must have its name.
  std::stable_partition(columns.begin(), columns.end(), [](const Column& c) { return c.name == "23"; });
  std::vector<Column> chosen;
  for (const Column& c : columns) {
    const auto collides = [&](const Column& other) {
      const double room = 0.008 * static_cast<double>(c.name.size() + other.name.size()) + 0.005;
      return std::fabs(axis.position(c.error) - axis.position(other.error)) < room;
    };
    if (std::none_of(chosen.begin(), chosen.end(), collides)) chosen.push_back(c);
  }
  return chosen;
}

}  // namespace

std::string plot_data(const Rows& rows, std::uint32_t frames) {
  std::string text = "# A block a tree: 1 - SSIM against binary64, against M 23; cycles a frame in thousands; M.\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SweepRow& r = rows[i];
    if (i == 0 || rows[i - 1].tree != r.tree) text += fmt::format("{}# {}\n", i == 0 ? "" : "\n\n", tree_name(r.tree));
    text += fmt::format("{:.6g} {:.6g} {:.6g} \"{}\"\n", distance(r.from_binary64), distance(r.from_binary32),
                        cost(r, frames), format_name(r.format));
  }
  for (const Panel& panel : panels) {
    text += fmt::format("\n\n# Names, {}: error, the cheapest and the dearest tree's cycles, M.\n", panel.title);
    for (const Column& c : labelled(columns_of(rows, panel, frames))) {
      text += fmt::format("{:.6g} {:.6g} {:.6g} \"{}\"\n", c.error, c.lowest, c.highest, c.name);
    }
  }
  return text;
}

std::string plot_script(const Rows& rows, std::uint32_t frames, const std::string& title) {
  const std::size_t trees = tree_count(rows);
  std::string body;
  int drawn = 0;
  for (std::size_t i = 0; i < std::size(panels); ++i) {
    const std::vector<Column> columns = columns_of(rows, panels[i], frames);
    if (columns.empty()) continue;
    body += fmt::format("set title '{}'\n", panels[i].title);
    body += error_axis(columns).commands('x') + cost_axis(columns).commands('y');
    body += fmt::format(
        "plot data index {0} using 1:2:(0):($3-$2) with vectors nohead linecolor rgb '#bbbbbb' dashtype 3 notitle, \\\n"
        "     for [i=0:{1}] data index i using {2}:3 with linespoints linestyle i+1 title word(trees, i+1), \\\n"
        "     data index {0} using 1:3:4 with labels font ',10' offset 0,0.8 notitle\n"
        "unset key\n",
        trees + i, trees - 1, panels[i].column);
    ++drawn;
  }
  if (drawn == 0) return "";
  std::string names;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i - 1].tree != rows[i].tree) {
      names += fmt::format("{}{}", i == 0 ? "" : " ", tree_name(rows[i].tree));
    }
  }
  return fmt::format(
      "# Cost against error; draw again with: gnuplot {0}.gnuplot\n"
      "data = '{0}.dat'\n"
      "trees = '{1}'\n"
      "set xlabel 'error: 1 - SSIM'\n"
      "set ylabel 'cost: cycles a frame, in thousands'\n"
      "set format '%g'\n"
      "set grid xtics ytics linecolor rgb '#e4e4e4'\n"
      "set bmargin 6\n"
      "set style line 1 linecolor rgb '#1f77b4' linewidth 1.5 pointtype 7 pointsize 0.7\n"
      "set style line 2 linecolor rgb '#d62728' linewidth 1.5 pointtype 5 pointsize 0.7\n"
      "set style line 3 linecolor rgb '#2ca02c' linewidth 1.5 pointtype 9 pointsize 0.9\n"
      "set style line 4 linecolor rgb '#9467bd' linewidth 1.5 pointtype 13 pointsize 0.9\n"
      "do for [kind in 'svg png'] {{\n"
      "if (kind eq 'svg') {{ set terminal svg size {2},560 font 'sans-serif,12' background 'white' }} \\\n"
      "else {{ set terminal pngcairo size {2},560 font 'Sans,11' }}\n"
      "set output 'cost-against-error.' . kind\n"
      "set multiplot layout 1,{3} title {4} noenhanced\n"
      "set key at screen 0.5,0.03 center horizontal\n"
      "{5}"
      "unset multiplot\n"
      "unset output\n"
      "}}\n",
      precision_plot, names, 640 * drawn, drawn, gnuplot_literal(title + "; points are named by M"), body);
}

}  // namespace artu::sim
