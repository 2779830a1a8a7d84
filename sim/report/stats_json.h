// stats.json, written frame by frame so that memory does not grow with their number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/compare/frame_compare.h"
#include "sim/energy/energy.h"
#include "sim/report/file.h"
#include "sim/report/numbers.h"
#include "sim/scaling/demand.h"

namespace artu::sim {

class StatsJson {
 public:
  /// Of the file's layout: changes when a name that exists changes its meaning or goes.
  static constexpr int schema = 1;

  explicit StatsJson(const std::string& file);
  /// `energy` is null where it was not computed, `check` where nothing was compared.
  void add_frame(std::uint32_t index, const Totals& frame, const std::vector<std::string>& violations,
                 const Energy* energy = nullptr);
  /// `demands` may be empty, where they are not known.
  void finish(const Totals& sum, std::uint32_t clock_mhz, const CheckResult* check, const Energy* energy = nullptr,
              const std::vector<Demand>& demands = {});

 private:
  OutputFile file_;
  bool first_ = true;
};

}  // namespace artu::sim
