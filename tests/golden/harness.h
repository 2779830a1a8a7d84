// Runs a scene through the unit and the golden model.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "golden/scenes.h"
#include "sim/compare/frame_compare.h"
#include "sim/compare/golden_settings.h"
#include "sim/driver/simulator.h"

namespace artu::golden_tests {

/// Outcomes of all frames; `check` holds the comparison.
struct Rendered {
  std::vector<sim::FrameOutcome> outcomes;
  sim::CheckResult check;
};

/// For refit: the frames from which others take their nodes.
inline sim::FrameFrom frames_of(const TestScene& test) {
  return [&test](std::uint32_t index) {
    const auto found = std::find_if(test.frames.begin(), test.frames.end(),
                                    [index](const traces::Frame& frame) { return frame.index >= index; });
    if (found == test.frames.end()) throw std::out_of_range("no such frame");
    return *found;
  };
}

inline Rendered run(const TestScene& test, const hw::UnitConfig& config = {},
                    const sim::SimulationOptions& options = {}) {
  Rendered run;
  sim::Simulator simulator(test.scene, config, options, frames_of(test));
  const ref::Golden golden(test.scene, sim::golden_settings(config));
  for (const traces::Frame& frame : test.frames) {
    run.outcomes.push_back(simulator.run(frame));
    sim::compare_frame(golden.render(frame), run.outcomes.back(), run.check);
  }
  return run;
}

/// No bit differs and every law holds.
inline void expect_exact(const Rendered& run) {
  EXPECT_TRUE(run.check.passed()) << sim::describe(run.check);
  for (const sim::FrameOutcome& outcome : run.outcomes) {
    EXPECT_TRUE(outcome.violations.empty()) << "frame " << outcome.index << ": " << outcome.violations.front();
  }
}

inline std::uint64_t counter(const sim::FrameOutcome& outcome, const std::string& block, const std::string& name) {
  for (const hw::Statistic& s : outcome.statistics) {
    if (s.block == block && s.name == name) return s.value;
  }
  ADD_FAILURE() << "no counter " << block << "." << name;
  return 0;
}

/// All counters as text: equal texts are equal cycles in every class of every block.
inline std::string all_counters(const sim::FrameOutcome& outcome) {
  std::string text = std::to_string(outcome.cycles) + "\n";
  for (const hw::Statistic& s : outcome.statistics) {
    text += s.block + "." + s.name + " " + std::to_string(s.value) + "\n";
  }
  return text;
}

/// All pixels as text.
inline std::string all_pixels(const sim::FrameOutcome& outcome) {
  std::string text;
  for (const hw::PixelRecord& p : outcome.pixels) {
    for (long long v : {static_cast<long long>(p.r), static_cast<long long>(p.g), static_cast<long long>(p.b),
                        static_cast<long long>(p.hit_class), static_cast<long long>(p.decision),
                        static_cast<long long>(p.threshold), static_cast<long long>(p.difference),
                        static_cast<long long>(p.primitive), static_cast<long long>(p.t_bits)}) {
      text += std::to_string(v) + ",";
    }
  }
  return text;
}

}  // namespace artu::golden_tests
