#include "sim/report/counters.h"

#include <stdexcept>

#include "sim/report/cycle_table.h"

namespace artu::sim {

Counters::Counters(const hw::Statistics& statistics) {
  for (const hw::Statistic& s : statistics) sums_[without_number(s.block)][s.name] += s.value;
}

std::uint64_t Counters::of(const std::string& block, const std::string& name) const {
  const auto counters = sums_.find(block);
  if (counters == sums_.end()) throw std::logic_error("counters: no block " + block);
  const auto counter = counters->second.find(name);
  if (counter == counters->second.end()) throw std::logic_error("counters: " + block + " has no counter " + name);
  return counter->second;
}

}  // namespace artu::sim
