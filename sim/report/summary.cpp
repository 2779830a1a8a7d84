#include "sim/report/summary.h"

#include <fmt/format.h>

#include "sim/energy/energy_report.h"

namespace artu::sim {
namespace {

/// 1234567 -> "1,234,567"
std::string grouped(double value) {
  std::string digits = fmt::format("{:.0f}", value);
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) digits.insert(at, ",");
  return digits;
}

double value_of(const std::vector<Number>& numbers, const std::string& name) {
  for (const Number& n : numbers) {
    if (n.name == name) return std::visit([](auto v) { return static_cast<double>(v); }, n.value);
  }
  return 0;
}

/// ", 95 % between A and B" a frame; nothing for a figure that is exact.
std::string interval_of(const Totals& sum, const std::string& name) {
  for (const Estimate& e : sum.estimates) {
    if (!e.block.empty() || e.name != name) continue;
    const auto frames = static_cast<double>(sum.frames);
    return fmt::format(", 95 % between {} and {}", grouped(e.low / frames), grouped(e.high / frames));
  }
  return "";
}

}  // namespace

std::string format_summary(const SummaryHeading& h, const Totals& sum, const Energy* energy,
                           const std::vector<Demand>& demands) {
  const auto numbers = frame_numbers(sum), derived = derived_numbers(sum, h.clock_mhz);
  const auto simulation = simulation_numbers(sum, -1);
  std::string out;
  const auto line = [&](const char* name, const std::string& text) { out += fmt::format("{:<12}{}\n", name, text); };
  line("scene", fmt::format("{}, {}x{}", h.scene, h.width, h.height));
  line("triangles", fmt::format("{} static, {} dynamic", grouped(static_cast<double>(sum.static_triangles)),
                                grouped(static_cast<double>(sum.dynamic_triangles))));
  line("frames", fmt::format("{} ({}:{})", sum.frames, h.first_frame, h.last_frame));
  line("fidelity", fmt::format("{}: {}", fidelity_name(sum.fidelity), promise_of(sum.fidelity)));
  const bool timed = has_cycles(sum.fidelity);
  if (timed) {
    line("cycles",
         fmt::format("{} per frame{}", grouped(value_of(derived, "cycles_per_frame")), interval_of(sum, "cycles")));
    line("speed", fmt::format("{:.2f} frames/s, {:.2f} Mrays/s at {} MHz", value_of(derived, "fps"),
                              value_of(derived, "mrays_per_second"), h.clock_mhz));
  }
  line("ray traced", fmt::format("{:.1f} % of the pixels", 100 * value_of(numbers, "traced_share")));
  if (timed) {
    line("DRAM", fmt::format("{:.3f} GB/s, {:.1f} bytes per ray", value_of(derived, "dram_gb_per_second"),
                             value_of(derived, "dram_bytes_per_ray")));
  }
  if (!demands.empty()) {
    const Demand most = bottleneck(demands);
    line("bottleneck", fmt::format("{} ({:.0f} % of its capacity)", most.resource, 100 * most.share));
  }
  if (energy != nullptr) {
    const auto energies = energy_numbers(*energy);
    line("energy", fmt::format("{:.1f} uJ per frame, {:.2f} nJ per ray, {:.1f} mW", value_of(energies, "frame_uj"),
                               value_of(energies, "ray_nj"), value_of(energies, "power_mw")));
  }
  const std::string cycles = grouped(value_of(simulation, "cycles_per_second")) + " cycles/s";
  line("simulation", fmt::format("{:.2f} s, {} rays/s{}", value_of(simulation, "wall_seconds"),
                                 grouped(value_of(simulation, "rays_per_second")), timed ? ", " + cycles : ""));
  line("memory", fmt::format("{} MB, {:.0f} bytes per triangle, {:.0f} bytes per pixel",
                             grouped(value_of(simulation, "peak_bytes") / 1e6),
                             value_of(simulation, "bytes_per_triangle"), value_of(simulation, "bytes_per_pixel")));
  return out;
}

}  // namespace artu::sim
