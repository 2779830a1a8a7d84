// Where the energy goes: how often each event happened in each block, and what it costs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hw/unit_config.h"
#include "sim/report/numbers.h"

namespace artu::sim {

/// `count` events of a kind in a block, each of so many pJ.  The kind is the parameter below `energy.` that prices it.
struct EnergyItem {
  std::string block, event;
  std::uint64_t count = 0;
  double price = 0;
  double picojoules() const { return static_cast<double>(count) * price; }
};

/// Of a frame, or of several together.
struct Energy {
  std::vector<EnergyItem> items;  // in a fixed order
  std::uint64_t frames = 0, cycles = 0, rays = 0, traced_pixels = 0;
  std::uint32_t clock_mhz = 0;

  using Shares = std::vector<std::pair<std::string, double>>;
  /// In pJ, in the order of the items.
  Shares by_block() const;
  Shares by_event() const;
  /// The sum of by_block(), in its order.
  double picojoules() const;
  double milliwatts() const;
};

/// From the counters alone.  Throws std::logic_error where one that it needs is not counted.
Energy energy_of(const Totals& totals, const hw::UnitConfig& unit);
/// None where the fidelity does not have all counters.
std::optional<Energy> energy_if_known(const Totals& totals, const hw::UnitConfig& unit);

}  // namespace artu::sim
