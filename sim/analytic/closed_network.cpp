#include "sim/analytic/closed_network.h"

#include <algorithm>

namespace artu::sim {

double closed_network(const std::vector<Station>& stations, double delay, double customers, double jobs,
                      double queueing) {
  if (jobs <= 0) return 0;
  customers = std::min(customers, jobs);
  std::vector<double> queue(stations.size(), customers / static_cast<double>(2 * stations.size() + 1));
  std::vector<double> at_station(stations.size(), 0);  // time of a job, waiting and being served
  double rate = 0;                                     // jobs in a unit of time
  for (int i = 0; i < 100; ++i) {
    double cycle = delay / jobs;
    for (std::size_t s = 0; s < stations.size(); ++s) {
      const double met = queue[s] * (customers - 1) / customers / stations[s].copies;
      at_station[s] = stations[s].demand / jobs * stations[s].copies * (1 + queueing * met);
      cycle += at_station[s];
    }
    if (cycle <= 0) return 0;
    rate = customers / cycle;
    for (std::size_t s = 0; s < stations.size(); ++s) queue[s] = (queue[s] + rate * at_station[s]) / 2;
  }
  double time = jobs / rate;
  for (const Station& station : stations) time = std::max(time, station.demand);
  return time;
}

}  // namespace artu::sim
