// The same frames with one parameter at several values: how the cycles scale, and what limits them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/scaling/demand.h"

namespace artu::sim {

/// A parameter and the values it is given, as written: "core.count=1,2,4".
struct Variation {
  std::string parameter;
  std::vector<std::string> values;
};

/// Throws InputError where the text is not PARAMETER=VALUE,VALUE...
Variation parse_variation(const std::string& text);

struct ScalingRow {
  std::string value;
  std::uint64_t cycles = 0, rays = 0, dram_bytes = 0;  // of all frames
  double speedup = 1;                                  // against the first value, in time
  double mrays_per_second = 0;
  double contexts = 0;  // contexts_filled
  std::vector<Demand> demands;
  std::string limit;
};

/// How long the unit takes, of all frames.
double microseconds(const Totals& totals, const hw::UnitConfig& unit);

/// `first_microseconds` are those of the first value.
ScalingRow scaling_row(const std::string& value, const Totals& totals, const hw::UnitConfig& unit,
                       double first_microseconds);

/// Columns: value, cycles a frame, speed-up, Mrays/s, DRAM GB/s ..., the largest demands, what limits.
std::string format_scaling(const Variation& variation, const std::vector<ScalingRow>& rows, std::uint32_t frames);
std::string scaling_csv(const Variation& variation, const std::vector<ScalingRow>& rows);

/// gnuplot's data and its script, which writes scaling.svg and scaling.png: speed-up above, demands below.
std::string scaling_data(const std::vector<ScalingRow>& rows);
std::string scaling_script(const Variation& variation, const std::vector<ScalingRow>& rows, const std::string& title);

inline constexpr const char* scaling_plot = "scaling";  // the name of its files

}  // namespace artu::sim
