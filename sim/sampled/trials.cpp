#include "sim/sampled/trials.h"

#include <algorithm>
#include <cmath>

#include "sim/energy/energy.h"

namespace artu::sim {

namespace {

struct Figure {
  const char* name;
  double (*of)(const Totals&, const hw::UnitConfig&);
};

constexpr Figure figures[] = {
    {"cycles", [](const Totals& t, const hw::UnitConfig&) { return static_cast<double>(t.cycles); }},
    {"rays", [](const Totals& t, const hw::UnitConfig&) { return static_cast<double>(t.rays()); }},
    {"node visits", [](const Totals& t, const hw::UnitConfig&) { return static_cast<double>(t.node_visits); }},
    {"triangle tests", [](const Totals& t, const hw::UnitConfig&) { return static_cast<double>(t.triangle_tests); }},
    {"DRAM reads", [](const Totals& t, const hw::UnitConfig&) { return static_cast<double>(t.dram_read_bytes); }},
    {"DRAM writes", [](const Totals& t, const hw::UnitConfig&) { return static_cast<double>(t.dram_write_bytes); }},
    {"energy", [](const Totals& t, const hw::UnitConfig& unit) { return energy_of(t, unit).picojoules(); }},
};

/// A sum in another order differs in its last bits.
bool between(double value, double low, double high) {
  const double rounding = 1e-9 * value;
  return value >= low - rounding && value <= high + rounding;
}

void take(const TotalEstimate& estimate, double exact, FigureTrials& trials) {
  const double error = exact == 0 ? 0 : std::abs(estimate.value / exact - 1);
  trials.mean_error += error;
  trials.worst_error = std::max(trials.worst_error, error);
  trials.half_interval += exact == 0 ? 0 : (estimate.high - estimate.low) / 2 / exact;
  trials.covered += between(exact, estimate.low, estimate.high) ? 1 : 0;
}

}  // namespace

Trials run_trials(const std::vector<FrameCost>& costs, const std::vector<Totals>& frames, double look_seconds,
                  const SampleSize& size, std::uint64_t seed, std::uint32_t count, const hw::UnitConfig& unit) {
  Trials trials;
  std::vector<std::vector<double>> values;  // by figure, frame
  for (const Figure& figure : figures) {
    trials.figures.push_back({figure.name});
    values.emplace_back();
    for (const Totals& frame : frames) values.back().push_back(figure.of(frame, unit));
  }
  const auto sum = [](const std::vector<double>& v) {
    double total = 0;
    for (const double x : v) total += x;
    return total;
  };
  double seconds = 0;
  for (const Totals& frame : frames) seconds += frame.simulation_seconds;
  for (std::uint32_t trial = 0; trial < count; ++trial) {
    FrameSample sample(costs, seed + trial);
    const std::uint32_t most = sample.different_frames();
    const auto total = [&](std::size_t figure) {
      std::vector<double> own;
      for (const std::uint32_t frame : sample.sample()) own.push_back(values[figure][frame]);
      return sample.total(own);
    };
    std::uint32_t wanted = size.first(most);
    do {
      sample.draw(wanted);
      wanted = size.needed(most, sample.drawn(), total(0).relative_error());
    } while (wanted > sample.drawn());
    double sampled_seconds = look_seconds;
    for (const std::uint32_t frame : sample.sample()) sampled_seconds += frames[frame].simulation_seconds;
    trials.frames_drawn += sample.drawn();
    trials.time_ratio += sampled_seconds == 0 ? 0 : seconds / sampled_seconds;
    for (std::size_t figure = 0; figure < values.size(); ++figure) {
      take(total(figure), sum(values[figure]), trials.figures[figure]);
    }
  }
  const double share = 1.0 / count;
  trials.frames_drawn *= share;
  trials.time_ratio *= share;
  for (FigureTrials& figure : trials.figures) {
    figure.mean_error *= share;
    figure.half_interval *= share;
    figure.covered *= share;
  }
  return trials;
}

}  // namespace artu::sim
