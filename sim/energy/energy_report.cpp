#include "sim/energy/energy_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace artu::sim {
namespace {

constexpr double pj_in_uj = 1e6, pj_in_nj = 1e3;

double ratio(double a, std::uint64_t b) { return b == 0 ? 0 : a / static_cast<double>(b); }

std::vector<Number> shares(const Energy::Shares& shares, std::uint64_t frames, const std::string& text) {
  std::vector<Number> numbers;
  for (const auto& [name, picojoules] : shares)
    numbers.push_back({name, ratio(picojoules, frames) / pj_in_uj, "uJ", text});
  return numbers;
}

}  // namespace

std::vector<Number> energy_numbers(const Energy& energy) {
  const double sum = energy.picojoules();
  return {
      {"total_uj", sum / pj_in_uj, "uJ", "all frames, DRAM and leakage included"},
      {"frame_uj", ratio(sum, energy.frames) / pj_in_uj, "uJ", "a frame, mean"},
      {"ray_nj", ratio(sum, energy.rays) / pj_in_nj, "nJ", "a ray, of all kinds, mean"},
      {"traced_pixel_nj", ratio(sum, energy.traced_pixels) / pj_in_nj, "nJ", "a ray-traced pixel, mean"},
      {"power_mw", energy.milliwatts(), "mW", "mean at the configured clock"},
  };
}

std::vector<Number> energy_blocks(const Energy& energy) {
  return shares(energy.by_block(), energy.frames, "of a frame's energy, by block; of the cores all together");
}

std::vector<Number> energy_events(const Energy& energy) {
  return shares(energy.by_event(), energy.frames, "of a frame's energy, by what the parameter energy.* prices");
}

std::string format_energy_table(const Energy& energy) {
  const Energy::Shares blocks = energy.by_block();
  const double sum = energy.picojoules();
  std::size_t width = 5;
  for (const auto& [block, share] : blocks) width = std::max(width, block.size());
  std::string out = fmt::format("{:<{}}{:>12}{:>11}{:>11}\n", "block", width, "uJ", "mW", "share");
  const auto row = [&](const std::string& name, double picojoules) {
    const double share = sum == 0 ? 0 : picojoules / sum;
    out += fmt::format("{:<{}}{:>12.3f}{:>11.2f}{:>10.1f}%\n", name, width, ratio(picojoules, energy.frames) / pj_in_uj,
                       energy.milliwatts() * share, 100 * share);
  };
  for (const auto& [block, share] : blocks) row(block, share);
  row("all", sum);
  return out;
}

}  // namespace artu::sim
