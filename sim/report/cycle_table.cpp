#include "sim/report/cycle_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace artu::sim {
namespace {

constexpr std::array<const char*, 5> classes{"busy", "stall_in", "stall_out", "stall_mem", "idle"};

}  // namespace

std::string without_number(const std::string& block) {
  for (const std::string prefix : {"core", "l2_bank"}) {
    if (block.compare(0, prefix.size(), prefix) != 0) continue;
    const std::size_t end = block.find_first_not_of("0123456789", prefix.size());
    if (end == prefix.size() || (end != std::string::npos && block[end] != '.')) continue;
    return (prefix == "core" ? prefix : "l2") + (end == std::string::npos ? "" : block.substr(end));
  }
  return block;
}

std::vector<CycleShares> cycle_shares(const hw::Statistics& statistics) {
  std::vector<CycleShares> shares;
  for (const hw::Statistic& s : statistics) {
    const auto column = std::find(classes.begin(), classes.end(), s.name);
    if (column == classes.end()) continue;
    const std::string block = without_number(s.block);
    auto row = std::find_if(shares.begin(), shares.end(), [&](const CycleShares& r) { return r.block == block; });
    if (row == shares.end()) row = shares.insert(shares.end(), CycleShares{block, {}});
    row->percent[column - classes.begin()] += static_cast<double>(s.value);
  }
  for (CycleShares& row : shares) {
    double sum = 0;
    for (const double cycles : row.percent) sum += cycles;
    for (double& cycles : row.percent) cycles = sum == 0 ? 0 : 100 * cycles / sum;
  }
  return shares;
}

std::string format_cycle_table(const hw::Statistics& statistics) {
  const std::vector<CycleShares> shares = cycle_shares(statistics);
  std::size_t width = 5;
  for (const CycleShares& row : shares) width = std::max(width, row.block.size());
  std::string out = fmt::format("{:<{}}", "block", width);
  for (const char* name : classes) out += fmt::format("{:>11}", name);
  out += '\n';
  for (const CycleShares& row : shares) {
    out += fmt::format("{:<{}}", row.block, width);
    for (const double percent : row.percent) out += fmt::format("{:>10.1f}%", percent);
    out += '\n';
  }
  return out;
}

}  // namespace artu::sim
