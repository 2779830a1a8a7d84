#include "sim/bench/measure.h"

#include <algorithm>
#include <memory>
#include <random>

#include "ref/golden.h"
#include "sim/compare/golden_settings.h"
#include "sim/driver/frame_simulator.h"
#include "sim/jobs/archive.h"
#include "sim/jobs/worker.h"
#include "sim/report/memory_use.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

/// One rendering of the frame.
struct Turn {
  double seconds = 0, cycles = 0;
  bool timed = false, estimated = false;  // has cycles; they are an estimate
  Interval interval;
  std::uint64_t primary_rays = 0, node_visits = 0, peak_bytes = 0;
};

/// A mode in its own process, where this object is used alone.
class Mode {
 public:
  Mode(const BenchFrame& frame, std::string name) : frame_(frame), name_(std::move(name)) {}

  std::string run() {
    Turn turn;
    if (name_ == golden_mode) {
      if (!golden_) golden_ = std::make_unique<ref::Golden>(frame_.scene, golden_settings(frame_.unit));
      const ref::Result result = golden_->render(frame_.frame);
      turn.seconds = result.trace_seconds;
      turn.primary_rays = result.rays.primary;
    } else {
      turn = simulated();
    }
    turn.peak_bytes = memory_.use().frames;
    return to_bytes(turn);
  }
  /// Before the first run, in the process.
  void begin() { memory_.loaded(); }

 private:
  Turn simulated() {
    if (!simulator_) {
      SimulationOptions options;
      options.fidelity = parse_fidelity(name_);
      simulator_ = make_simulator(frame_.scene, frame_.unit, options, [this](std::uint32_t) { return frame_.frame; });
    }
    const FrameOutcome outcome = simulator_->run(frame_.frame);
    Turn turn;
    turn.seconds = outcome.simulation_seconds;
    turn.timed = has_cycles(outcome.fidelity);
    turn.cycles = static_cast<double>(outcome.cycles);
    for (const Estimate& e : outcome.estimates) {
      if (!e.block.empty() || e.name != "cycles") continue;
      turn.estimated = true;
      turn.interval = {e.low, e.high};
    }
    turn.primary_rays = outcome.rays_primary;
    turn.node_visits = outcome.node_visits;
    return turn;
  }

  const BenchFrame& frame_;
  const std::string name_;
  MemoryMeter memory_;
  std::unique_ptr<ref::Golden> golden_;
  std::unique_ptr<FrameSimulator> simulator_;
};

/// The process of a mode, and what it gave so far.
struct Running {
  std::unique_ptr<Worker> worker;
  ModeResult result;
};

void add(const Turn& turn, bool timed, ModeResult& result) {
  if (timed) result.seconds.push_back(turn.seconds);
  if (turn.timed) result.cycles = turn.cycles;
  if (turn.estimated) result.interval = turn.interval;
  result.primary_rays = turn.primary_rays;
  result.node_visits = turn.node_visits;
  result.peak_bytes = std::max(result.peak_bytes, turn.peak_bytes);
}

Turn turn_of(Worker& worker, std::uint64_t round) {
  worker.give(round);
  return from_bytes<Turn>(worker.wait().result());
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  if (below + 1 == values.size()) return values[below];
  return values[below] + (at - static_cast<double>(below)) * (values[below + 1] - values[below]);
}

double ModeResult::median() const { return quantile(seconds, 0.5); }

double ModeResult::spread() const {
  const double middle = median();
  return middle > 0 ? (quantile(seconds, 0.75) - quantile(seconds, 0.25)) / middle : 0;
}

std::vector<ModeResult> measure(const BenchFrame& frame, const BenchPlan& plan, std::vector<std::string>& notes) {
  std::vector<Running> running;
  for (const std::string& name : plan.modes) {
    Mode mode(frame, name);
    std::vector<int> others;
    for (const Running& other : running) others.push_back(other.worker->fd());
    bool begun = false;  // in the process
    Running one{std::make_unique<Worker>(
                    [&](std::uint64_t) {
                      if (!begun) mode.begin();
                      begun = true;
                      return mode.run();
                    },
                    others),
                {}};
    one.result.mode = name;
    try {
      add(turn_of(*one.worker, 0), false, one.result);
    } catch (const InputError& error) {
      notes.push_back(frame.scene.name + ": " + name + " left out: " + error.what());
      continue;
    }
    running.push_back(std::move(one));
  }
  std::mt19937_64 random(plan.seed);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < running.size(); ++i) order.push_back(i);
  for (std::uint32_t round = 1; round <= plan.repeats; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) add(turn_of(*running[i].worker, round), true, running[i].result);
  }
  std::vector<ModeResult> results;
  for (Running& one : running) results.push_back(std::move(one.result));
  return results;
}

const ModeResult* find(const std::vector<ModeResult>& results, const std::string& mode) {
  const auto found = std::find_if(results.begin(), results.end(), [&](const ModeResult& r) { return r.mode == mode; });
  return found == results.end() ? nullptr : &*found;
}

}  // namespace artu::sim
