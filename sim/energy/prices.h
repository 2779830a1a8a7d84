// What one event costs in a unit, in pJ: the table of `energy.*` for its formats and sizes (docs/energy.md has the
// laws).
#pragma once

#include "hw/unit_config.h"

namespace artu::sim {

/// Of each operator in a format.
struct OperatorPrices {
  double add = 0, multiply = 0, divide = 0, square_root = 0, compare = 0;
};

/// With so many stored fraction bits.
OperatorPrices operator_prices(const hw::EnergyConfig& energy, std::uint32_t fraction_bits);

/// A line read from or written to an array of so many bytes, a power of two.
double line_price(const hw::EnergyConfig& energy, std::uint32_t size);

/// A power in mW as energy a cycle.
double cycle_price(double milliwatts, std::uint32_t clock_mhz);

}  // namespace artu::sim
