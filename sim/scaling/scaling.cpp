#include "sim/scaling/scaling.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/report/csv.h"
#include "traces/error.h"

namespace artu::sim {

Variation parse_variation(const std::string& text) {
  const auto refuse = [&] {
    throw InputError("--vary",
                     fmt::format("\"{}\" is not PARAMETER=VALUE,VALUE...; core.count=1,2,4 would be right", text));
  };
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) refuse();
  Variation variation{text.substr(0, equals), {}};
  for (std::size_t at = equals + 1; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    variation.values.push_back(text.substr(at, end - at));
    if (variation.values.back().empty()) refuse();
    at = end + 1;
  }
  if (variation.values.empty()) refuse();
  return variation;
}

double microseconds(const Totals& totals, const hw::UnitConfig& unit) {
  return static_cast<double>(totals.cycles) / unit.clock_mhz;
}

ScalingRow scaling_row(const std::string& value, const Totals& totals, const hw::UnitConfig& unit,
                       double first_microseconds) {
  ScalingRow row;
  row.value = value;
  row.cycles = totals.cycles;
  row.rays = totals.rays();
  row.dram_bytes = totals.dram_read_bytes + totals.dram_write_bytes;
  row.speedup = first_microseconds / microseconds(totals, unit);
  row.mrays_per_second = static_cast<double>(totals.rays()) * unit.clock_mhz / static_cast<double>(totals.cycles);
  row.contexts = contexts_filled(totals, unit);
  row.demands = demands(totals, unit);
  row.limit = limit_of(totals, unit);
  return row;
}

std::string format_scaling(const Variation& variation, const std::vector<ScalingRow>& rows, std::uint32_t frames) {
  std::size_t width = variation.parameter.size();
  for (const ScalingRow& row : rows) width = std::max(width, row.value.size());
  std::string out =
      fmt::format("{:<{}}  {:>10} {:>8} {:>8} {:>9} {:>8} {:>8} {:>8} {:>8} {:>8}  {}\n", variation.parameter, width,
                  "cycles", "speed-up", "Mrays/s", "DRAM MB", "boxes", "tris", "L2", "DRAM", "contexts", "limited by");
  for (const ScalingRow& row : rows) {
    const auto percent = [&](std::size_t i) { return fmt::format("{:.0f}%", 100 * row.demands[i].share); };
    out += fmt::format("{:<{}}  {:>10.0f} {:>8.2f} {:>8.1f} {:>9.2f} {:>8} {:>8} {:>8} {:>8} {:>8}  {}\n", row.value,
                       width, static_cast<double>(row.cycles) / frames, row.speedup, row.mrays_per_second,
                       static_cast<double>(row.dram_bytes) / frames / 1e6, percent(0), percent(1), percent(5),
                       percent(6), fmt::format("{:.0f}%", 100 * row.contexts), row.limit);
  }
  return out;
}

std::string scaling_csv(const Variation& variation, const std::vector<ScalingRow>& rows) {
  std::string out = variation.parameter + ",cycles,speedup,rays,mrays_per_second,dram_bytes,contexts_filled";
  for (const Demand& demand : rows.at(0).demands) {
    std::string name = "demand_" + demand.resource;
    name.erase(std::remove(name.begin(), name.end(), ','), name.end());
    std::replace(name.begin(), name.end(), ' ', '_');
    out += "," + name;
  }
  out += ",limited_by\n";
  for (const ScalingRow& row : rows) {
    out += fmt::format("{},{},{},{},{},{},{}", row.value, row.cycles, row.speedup, row.rays, row.mrays_per_second,
                       row.dram_bytes, row.contexts);
    for (const Demand& demand : row.demands) out += fmt::format(",{}", demand.share);
    out += "," + csv_field(row.limit) + "\n";
  }
  return out;
}

}  // namespace artu::sim
