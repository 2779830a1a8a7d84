#include "sim/analytic/dram_service.h"

#include <algorithm>

#include "sim/analytic/closed_network.h"
#include "sim/analytic/constants.h"

namespace artu::sim {

double bus_cycles(const hw::UnitConfig& config) {
  const hw::DramConfig& dram = config.memory.dram;
  const std::uint32_t bits = dram.bus_bits * dram.burst_length, bursts = (64 * 8 + bits - 1) / bits;
  return bursts * dram.burst_length / 2.0 * config.clock_mhz / dram.clock_mhz / dram.channels;
}

DramService::DramService(const hw::UnitConfig& config, const DramLoad& load) {
  const hw::DramConfig& dram = config.memory.dram;
  const double cycles = static_cast<double>(config.clock_mhz) / dram.clock_mhz;  // of a DRAM clock
  const double lines = load.reads + load.writes, reads = std::max(load.reads, 1.0);
  const double a_read = std::max(lines / reads, 1.0);  // lines of which one is a read
  const double misses = lines == 0 ? 0 : std::min(load.row_misses / lines, 1.0);
  const double data = bus_cycles(config) * dram.channels;
  const double row = (dram.t_rp + dram.t_ras) * cycles * calibrated.row_share;
  const bool refreshes = dram.refresh == hw::RefreshPolicy::all_bank && dram.t_rfc < dram.t_refi;
  const double refresh = refreshes ? 1 - static_cast<double>(dram.t_rfc) / dram.t_refi : 1;
  const double bus = data / refresh * calibrated.bus;
  const double activates = misses * dram.t_faw / 4 * cycles;  // four activates in t_faw
  const double banks = static_cast<double>(dram.channels) * dram.banks;
  const double delay = (misses * dram.t_rcd + dram.t_cl) * cycles + data;
  const std::vector<Station> stations = {
      {"banks", a_read * (misses * row + (1 - misses) * data) / banks, banks},
      {"buses", a_read * std::max(bus, activates) / dram.channels, static_cast<double>(dram.channels)}};
  // Of one read; many of them, so that customers never run out.
  constexpr double many = 1e9;
  std::vector<Station> all = stations;
  for (Station& station : all) station.demand *= many;
  const double most = std::max(1.0, config.memory.l2.mshrs * calibrated.l2_mshrs);
  double n = 1;
  while (true) {
    curve_.push_back({n, many / closed_network(all, delay * many, n, many, calibrated.dram_queueing)});
    if (n >= most) break;
    n = std::min(most, std::max(n + 1, n * 1.5));
  }
}

double DramService::response(double rate) const {
  Point before{0, 0};
  for (const Point& point : curve_) {
    if (point.rate >= rate) {
      if (before.customers == 0) return alone();
      const double share = (rate - before.rate) / std::max(point.rate - before.rate, 1e-12);
      return (before.customers + share * (point.customers - before.customers)) / rate;
    }
    before = point;
  }
  return before.customers / before.rate;
}

}  // namespace artu::sim
