#include "sim/energy/energy.h"

#include <algorithm>

namespace artu::sim {
namespace {

Energy::Shares shares_of(const std::vector<EnergyItem>& items, std::string EnergyItem::*key) {
  Energy::Shares shares;
  for (const EnergyItem& item : items) {
    const auto same = [&](const auto& share) { return share.first == item.*key; };
    auto share = std::find_if(shares.begin(), shares.end(), same);
    if (share == shares.end()) share = shares.insert(shares.end(), {item.*key, 0.0});
    share->second += item.picojoules();
  }
  return shares;
}

}  // namespace

Energy::Shares Energy::by_block() const { return shares_of(items, &EnergyItem::block); }

Energy::Shares Energy::by_event() const { return shares_of(items, &EnergyItem::event); }

double Energy::picojoules() const {
  double sum = 0;
  for (const auto& [block, share] : by_block()) sum += share;
  return sum;
}

std::optional<Energy> energy_if_known(const Totals& totals, const hw::UnitConfig& unit) {
  if (!has_energy(totals.fidelity)) return {};
  return energy_of(totals, unit);
}

double Energy::milliwatts() const {
  if (cycles == 0) return 0;
  return picojoules() * clock_mhz / static_cast<double>(cycles) / 1000;  // pJ * MHz = uW
}

}  // namespace artu::sim
