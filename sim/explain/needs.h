// From counters to cycles that a resource is needed for: part of accounting.h.
#pragma once

#include <string>

#include "sim/explain/accounting.h"
#include "sim/report/counters.h"

namespace artu::sim {

/// The blocks' counters as numbers, the cores' together, and those of one core or bank.
class WorkCounts {
 public:
  explicit WorkCounts(const hw::Statistics& statistics) : statistics_(statistics), sums_(statistics) {}

  double of(const std::string& block, const std::string& name) const {
    return static_cast<double>(sums_.of(block, name));
  }
  double rays() const;
  /// The largest of a block's copies, over their mean; 1 if there is nothing.
  double unevenness(const std::string& block_of_core, const std::string& name) const;
  /// Requests and answers of misses, by bank of the L2.
  std::vector<double> l2_banks() const;

 private:
  const hw::Statistics& statistics_;
  Counters sums_;
};

std::array<double, resource_count> needs_of(const WorkCounts& work, const hw::UnitConfig& unit, const Accounting& a);

/// What all pixels together are in the cores' pipelines for, each step at its latency, with no waiting at all.
double pipeline_cycles(const WorkCounts& work, const hw::UnitConfig& unit);

}  // namespace artu::sim
