#include "sim/energy/prices.h"

#include "hw/fabric/memory_port.h"

namespace artu::sim {

OperatorPrices operator_prices(const hw::EnergyConfig& energy, std::uint32_t fraction_bits) {
  constexpr double binary32_significand = 24;
  const hw::OperatorEnergy& o = energy.operators;
  const double width = (fraction_bits + 1) / binary32_significand, area = width * width;
  const double overhead = o.multiply_overhead, scale = energy.scale;
  OperatorPrices prices;
  prices.add = o.add * width * scale;
  prices.multiply = o.multiply * (overhead + (1 - overhead) * area) * scale;
  prices.divide = o.divide * area * scale;
  prices.square_root = o.square_root * area * scale;
  prices.compare = o.compare * width * scale;
  return prices;
}

double line_price(const hw::EnergyConfig& energy, std::uint32_t size) {
  // Doublings are multiplied, not raised to a power: a product has the same bits on every machine.
  constexpr std::uint32_t published_size = 8192, published_bytes = 8;
  const double growth = energy.sram.growth;
  double price = energy.sram.access * (double{hw::line_bytes} / published_bytes) * energy.scale;
  for (std::uint32_t s = published_size; s < size; s *= 2) price *= growth;
  for (std::uint32_t s = published_size; s > size; s /= 2) price /= growth;
  return price;
}

double cycle_price(double milliwatts, std::uint32_t clock_mhz) { return milliwatts * 1000 / clock_mhz; }

}  // namespace artu::sim
