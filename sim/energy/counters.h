// The blocks' counters by name, with a loud end for a name that nobody counts.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "hw/fabric/statistics.h"

namespace artu::sim {

class Counters {
 public:
  explicit Counters(const hw::Statistics& statistics);

  /// The sum over the cores: block is "core.traversal", "l2" ...  An unknown name is an error of the model, not a zero:
  /// std::logic_error.
  std::uint64_t of(const std::string& block, const std::string& name) const;

 private:
  std::map<std::string, std::map<std::string, std::uint64_t>> sums_;
};

}  // namespace artu::sim
