#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/quality/front.h"
#include "sim/quality/policies.h"
#include "sim/quality/report.h"

namespace artu::sim {
namespace {

using Cells = std::vector<std::string>;

/// The first cell to the left, the others to the right.
std::string line(const Cells& cells, const std::vector<int>& widths) {
  std::string text = fmt::format("{:<{}}", cells[0], widths[0]);
  for (std::size_t i = 1; i < cells.size(); ++i) text += fmt::format("{:>{}}", cells[i], widths[i]);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

std::string decibels(double psnr) {
  return std::isnan(psnr) ? "-" : std::isinf(psnr) ? "same" : fmt::format("{:.2f}", psnr);
}

std::string number(double value, const char* format) {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

template <class T>
std::string per_frame(const std::optional<T>& sum, double unit, const char* format) {
  return sum ? fmt::format(fmt::runtime(format), static_cast<double>(*sum) / unit) : "-";
}

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

std::string format_quality(const std::vector<QualityRow>& rows, std::uint32_t frames) {
  static const std::vector<int> widths = {15, 6, 8, 8, 9, 8, 8, 9, 9, 9, 9, 10, 9};
  std::string text = fmt::format("{:23}{:-^31}  {:-^34}  {:-^17}\n", "", " per frame ",
                                 " PSNR from the full render, dB ", " whole frame ");
  text += line({"policy", "ref", "traced", "rays", "cycles", "DRAM", "energy", "all", "dynamic", "static", "backgr",
                "SSIM", "FLIP"},
               widths);
  text += line({"", "", "%", "k", "k", "MB", "uJ", "", "", "", "", "", ""}, widths);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const QualityRow& row = rows[i];
    if (i > 0 && row.reference && rows[i - 1].policy != row.policy) text += "\n";
    const AreaError& all = row.errors.of(Area::whole);
    Cells cells{row.policy,
                row.reference ? fmt::format("{}", *row.reference) : "",
                fmt::format("{:.2f}", 100 * row.traced_share()),
                fmt::format("{:.1f}", static_cast<double>(row.rays) / frames / 1e3),
                per_frame(row.cycles, 1e3 * frames, "{:.0f}"),
                per_frame(row.dram_bytes, 1e6 * frames, "{:.2f}"),
                per_frame(row.picojoules, 1e6 * frames, "{:.1f}")};
    for (const AreaError& area : row.errors.areas) cells.push_back(decibels(area.psnr()));
    cells.push_back(number(all.mean_ssim(), "{:.5f}"));
    cells.push_back(number(all.mean_flip(), "{:.5f}"));
    text += line(cells, widths);
  }
  return text;
}

std::string format_equal_shares(const std::vector<QualityRow>& rows, const std::vector<double>& shares) {
  static const std::vector<int> widths = {9, 14, 9, 8, 9, 8, 9, 8, 9, 8, 10, 9};
  std::string text =
      fmt::format("At equal work: PSNR in dB between the points, and its gain over \"{}\"\n", plain_policy);
  text +=
      line({"traced %", "policy", "all", "gain", "dynamic", "gain", "static", "gain", "backgr", "gain", "FLIP", "gain"},
           widths);
  for (const double share : shares) {
    const FrontValue plain = front_at(rows, plain_policy, share);
    for (const std::string& policy : policies_of(rows)) {
      const FrontValue value = front_at(rows, policy, share);
      Cells cells{fmt::format("{:g}", 100 * share), policy};
      for (std::size_t i = 0; i < area_count; ++i) {
        cells.push_back(number(value.psnr[i], "{:.2f}"));
        cells.push_back(number(value.psnr[i] - plain.psnr[i], "{:+.2f}"));
      }
      cells.push_back(number(value.flip, "{:.5f}"));
      cells.push_back(number(plain.flip - value.flip, "{:+.5f}"));
      text += line(cells, widths);
    }
  }
  return text;
}

std::string format_attribution(const std::vector<QualityRow>& rows) {
  static const std::vector<int> widths = {18, 10, 6, 24, 12, 10, 10};
  std::string text = "Where the squared error comes from: % of the pixels, and of the error\n";
  text += line({"", "cause", "pass", "pair", "pixel", "pixels %", "error %"}, widths);
  for (const QualityRow& row : rows) {
    if (!row.shown || !row.attribution) continue;
    const std::uint64_t squares = row.attribution->squares();
    Share of_cause[std::size(cause_names)];
    std::vector<std::pair<Decided, Share>> largest;
    for (const auto& [what, share] : row.attribution->shares()) {
      Share& sum = of_cause[static_cast<std::size_t>(what.cause)];
      sum.pixels += share.pixels;
      sum.squares += share.squares;
      if (percent(share.squares, squares) >= 5) largest.emplace_back(what, share);
    }
    std::stable_sort(largest.begin(), largest.end(),
                     [](const auto& a, const auto& b) { return a.second.squares > b.second.squares; });
    const auto shares = [&](Cells cells, const Share& share) {
      cells.push_back(fmt::format("{:.2f}", percent(share.pixels, row.pixels)));
      cells.push_back(fmt::format("{:.2f}", percent(share.squares, squares)));
      text += line(cells, widths);
    };
    for (std::size_t i = 0; i < std::size(cause_names); ++i) {
      shares({i == 0 ? row.name() : "", cause_names[i], "", "all", "all"}, of_cause[i]);
    }
    for (const auto& [what, share] : largest) {
      shares({"", cause_names[static_cast<std::size_t>(what.cause)], fmt::format("{}", what.pass), what.pair(),
              area_names[static_cast<std::size_t>(what.pixel)]},
             share);
    }
  }
  return text;
}

}  // namespace artu::sim
