#include "sim/report/stats_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/energy/energy_report.h"
#include "sim/report/cycle_table.h"

namespace artu::sim {
namespace {

std::vector<Number> prefixed(const std::string& prefix, std::vector<Number> numbers) {
  for (Number& number : numbers) number.name = prefix + number.name;
  return numbers;
}

/// Everything that a report holds, in the order of stats.json.
std::vector<Number> all_numbers(const Totals& sum, std::uint32_t clock_mhz, double golden_seconds,
                                const Energy* energy) {
  std::vector<Number> all = {{"frames", sum.frames, "frames", "simulated"}};
  const auto append = [&](const std::vector<Number>& more) { all.insert(all.end(), more.begin(), more.end()); };
  append(frame_numbers(sum));
  for (const hw::Statistic& s : sum.statistics) all.push_back({s.block + "." + s.name, s.value, s.unit, s.text});
  append(prefixed("derived.", derived_numbers(sum, clock_mhz)));
  if (energy != nullptr) {
    append(prefixed("energy.", energy_numbers(*energy)));
    append(prefixed("energy.blocks.", energy_blocks(*energy)));
    append(prefixed("energy.events.", energy_events(*energy)));
  }
  append(prefixed("simulation.", simulation_numbers(sum, golden_seconds)));
  return all;
}

double value_of(const std::vector<Number>& numbers, const std::string& name) {
  const auto found = std::find_if(numbers.begin(), numbers.end(), [&](const Number& n) { return n.name == name; });
  return found == numbers.end() ? 0 : std::visit([](auto v) { return static_cast<double>(v); }, found->value);
}

}  // namespace

std::string format_stats(const Totals& sum, std::uint32_t clock_mhz, double golden_seconds, const Energy* energy) {
  const std::vector<Number> numbers = all_numbers(sum, clock_mhz, golden_seconds, energy);
  std::string out = fmt::format("# {} frame{}", sum.frames, sum.frames == 1 ? "" : "s");
  if (has_cycles(sum.fidelity)) {
    out += fmt::format(" at {} MHz: {:.0f} cycles per frame, {:.2f} fps, {:.2f} Mrays/s", clock_mhz,
                       value_of(numbers, "derived.cycles_per_frame"), value_of(numbers, "derived.fps"),
                       value_of(numbers, "derived.mrays_per_second"));
  }
  out += fmt::format(", {:.1f} % of the pixels ray traced\n", 100 * value_of(numbers, "traced_share"));
  out += fmt::format("# {}: {}\n", fidelity_name(sum.fidelity), promise_of(sum.fidelity));
  if (has_energy(sum.fidelity)) {
    out += "\n# Where do the cycles go: all frames together, \"core\" is the mean of the cores\n";
    out += format_cycle_table(sum.statistics);
  }
  if (energy != nullptr) {
    out += "\n# Where does the energy go: a frame, mean; all cores together\n";
    out += format_energy_table(*energy);
  }
  out += "\n# All numbers, summed over the frames: name value unit # text\n";
  // No real is wider than 12, so that wall times do not move the columns of a run that is repeated.
  std::size_t name = 0, value = 12, unit = 0;
  for (const Number& n : numbers) {
    name = std::max(name, n.name.size());
    value = std::max(value, value_text(n).size());
    unit = std::max(unit, n.unit.size());
  }
  for (const Number& n : numbers) {
    out += fmt::format("{:<{}}  {:>{}}  {:<{}}  # {}\n", n.name, name, value_text(n), value, n.unit, unit, n.text);
  }
  if (!sum.estimates.empty()) out += "\n# Estimates with their 95 % intervals: name value low high unit\n";
  for (const Estimate& e : sum.estimates) {
    const std::string full = e.block.empty() ? e.name : e.block + "." + e.name;
    out += fmt::format("{:<{}}  {:>{}.6g}  {:>{}.6g}  {:>{}.6g}  {}\n", full, name, e.value, value, e.low, value,
                       e.high, value, e.unit);
  }
  return out;
}

std::string format_stats_list(const Totals& sum, std::uint32_t clock_mhz, const Energy* energy) {
  std::vector<Number> numbers = all_numbers(sum, clock_mhz, 0, energy);
  // The other cores' counters have the same names.
  const auto repeated = [](const Number& n) {
    const bool first = n.name.rfind("core0.", 0) == 0 || n.name.rfind("l2_bank0.", 0) == 0;
    return !first && without_number(n.name) != n.name;
  };
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), repeated), numbers.end());
  std::size_t name = 4, unit = 4;
  for (const Number& n : numbers) {
    name = std::max(name, n.name.size());
    unit = std::max(unit, n.unit.size());
  }
  std::string out = fmt::format("{:<{}}  {:<{}}  {}\n", "name", name, "unit", unit, "text");
  for (const Number& n : numbers) out += fmt::format("{:<{}}  {:<{}}  {}\n", n.name, name, n.unit, unit, n.text);
  return out;
}

}  // namespace artu::sim
