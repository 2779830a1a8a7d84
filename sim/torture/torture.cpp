#include "sim/torture/torture.h"

#include <algorithm>
#include <stdexcept>

#include "sim/compare/frame_compare.h"
#include "sim/compare/golden_settings.h"
#include "sim/config/configuration.h"
#include "sim/torture/drawn_unit.h"
#include "traces/error.h"
#include "traces/validate.h"

namespace artu::sim {
namespace {

constexpr std::uint64_t most_clocked_cycles = 50000;  // of a frame: it takes a hundred times as long as event

/// Where the counters of two runs are not the same; "" if they are.
std::string difference(const FrameOutcome& event, const FrameOutcome& clocked) {
  const auto text = [](const char* what, std::uint64_t a, std::uint64_t b) {
    return std::string(what) + " is " + std::to_string(a) + " in event and " + std::to_string(b) + " in clocked";
  };
  if (event.cycles != clocked.cycles) return text("cycles", event.cycles, clocked.cycles);
  for (std::size_t i = 0; i < event.statistics.size(); ++i) {
    const hw::Statistic &a = event.statistics[i], &b = clocked.statistics.at(i);
    if (a.value != b.value) return text((a.block + "." + a.name).c_str(), a.value, b.value);
  }
  return "";
}

TortureResult simulate(const TortureCase& drawn) {
  const hw::UnitConfig unit = Configuration::of({}, drawn.assignments).unit();
  const DrawnScene scene = make_scene(drawn.scene);
  traces::validate(scene.scene, "torture");
  const FrameFrom frames = [&scene](std::uint32_t index) { return scene.frames.at(index); };
  const auto simulator = make_simulator(scene.scene, unit, drawn.simulation, frames);
  std::unique_ptr<FrameSimulator> clocked;
  if (drawn.clocked_too) {
    SimulationOptions options = drawn.simulation;
    options.fidelity = Fidelity::clocked;
    clocked = make_simulator(scene.scene, unit, options, frames);
  }
  const ref::Golden golden(scene.scene, golden_settings(unit));
  TortureResult result;
  for (const traces::Frame& frame : scene.frames) {
    traces::validate(scene.scene, frame, "torture");
    const FrameOutcome outcome = simulator->run(frame);
    CheckResult check;
    compare_frame(golden.render(frame), outcome, check);
    result.pixels += check.pixels;
    result.cycles += outcome.cycles;
    if (!check.passed()) return {Verdict::mismatch, describe(check), result.pixels, result.cycles};
    if (!outcome.violations.empty()) {
      return {Verdict::unlawful, outcome.violations.front(), result.pixels, result.cycles};
    }
    if (!clocked || outcome.cycles > most_clocked_cycles) continue;
    const std::string unlike = difference(outcome, clocked->run(frame));
    if (!unlike.empty()) return {Verdict::mismatch, unlike, result.pixels, result.cycles};
  }
  return result;
}

}  // namespace

const char* verdict_name(Verdict verdict) {
  static const char* const names[verdict_count] = {"fine",       "refused",   "mismatch",
                                                   "broken law", "dead-lock", "exception"};
  return names[static_cast<std::size_t>(verdict)];
}

TortureCase draw_case(std::uint64_t seed) {
  Random random(seed);
  TortureCase drawn;
  drawn.seed = seed;
  drawn.assignments = draw_unit(random);
  drawn.scene = draw_recipe(random);
  drawn.simulation.random_stall = random.below(4) != 0;
  drawn.simulation.shuffle_ticks = random.below(2) != 0;
  drawn.simulation.seed = seed;
  drawn.clocked_too = random.below(8) == 0;
  return drawn;
}

TortureResult run_case(const TortureCase& drawn) {
  try {
    return simulate(drawn);
  } catch (const InputError& error) {
    return {Verdict::refused, error.what()};
  } catch (const DeadLock& error) {
    return {Verdict::dead_lock, error.what()};
  } catch (const std::exception& error) {
    return {Verdict::exception, error.what()};
  }
}

TortureCase shrink(TortureCase failing, Verdict verdict) {
  const auto still_fails = [&](const TortureCase& smaller) {
    if (run_case(smaller).verdict != verdict) return false;
    failing = smaller;
    return true;
  };
  for (bool* option : {&failing.simulation.shuffle_ticks, &failing.simulation.random_stall, &failing.clocked_too}) {
    if (!*option) continue;
    *option = false;
    if (run_case(failing).verdict != verdict) *option = true;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = failing.assignments.size(); i-- > 0;) {
      TortureCase smaller = failing;
      smaller.assignments.erase(smaller.assignments.begin() + static_cast<std::ptrdiff_t>(i));
      changed |= still_fails(smaller);
    }
    for (const SceneRecipe::Number& number : SceneRecipe::numbers()) {
      const std::uint32_t before = failing.scene.*number.value;
      for (const std::uint32_t value : {number.least, before / 2, before - 1}) {
        if (value < number.least || value >= before) continue;
        TortureCase smaller = failing;
        smaller.scene.*number.value = value;
        if (!still_fails(smaller)) continue;
        changed = true;
        break;
      }
    }
  }
  return failing;
}

}  // namespace artu::sim
