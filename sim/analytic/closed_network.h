// A closed queueing network: how long a fixed number of customers, each of which starts anew when it is done, need for
// so many jobs.  Approximate mean value analysis (Reiser and Lavenberg, JACM 1980; Schweitzer 1979).
#pragma once

#include <string>
#include <vector>

namespace artu::sim {

/// A resource that serves one job at a time, or `copies` of it among which jobs are spread evenly.
struct Station {
  std::string name;
  double demand = 0;  // time that each copy is busy for all jobs together
  double copies = 1;
};

/// Time for all jobs; no less than the largest demand, and than `delay / customers`.  `delay`: time of all jobs
/// together outside of the stations, as if each were alone.  `queueing`: how much of the queue that a customer meets it
/// waits for; 1 for exponential times of service, 1/2 for constant ones.
double closed_network(const std::vector<Station>& stations, double delay, double customers, double jobs,
                      double queueing);

}  // namespace artu::sim
