// The numbers of a run, each declared once with name, unit and text; JSON, text and `--list-stats` all print these.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "hw/fabric/statistics.h"
#include "sim/driver/frame_outcome.h"
#include "sim/report/memory_use.h"

namespace artu::sim {

/// A dotted name is a path in stats.json: `rays.primary`.
struct Number {
  std::string name;
  std::variant<std::uint64_t, double> value;
  std::string unit;
  std::string text;
};

/// What one frame counted, or several together.
struct Totals {
  Fidelity fidelity = Fidelity::event;
  std::uint64_t frames = 0, cycles = 0;
  std::uint64_t static_triangles = 0, dynamic_triangles = 0;  // of the largest frame
  TreeQuality dynamic_tree;  // the largest of each, but the expected tests: the costliest's
  std::uint64_t sampled = 0, interpolated = 0, traced = 0;    // pixels by decision
  std::uint64_t miss = 0, static_hits = 0, dynamic_hits = 0;  // pixels with a ray, by its class
  std::uint64_t rays_primary = 0, rays_shadow = 0, rays_reflection = 0, rays_refraction = 0;
  std::uint64_t node_visits = 0, triangle_tests = 0;
  std::uint64_t dram_read_bytes = 0, dram_write_bytes = 0;
  double simulation_seconds = 0;
  hw::Statistics statistics;        // the blocks' counters
  std::vector<Estimate> estimates;  // the intervals of those that are estimates
  MemoryUse memory;                 // of the host

  std::uint64_t rays() const { return rays_primary + rays_shadow + rays_reflection + rays_refraction; }
  std::uint64_t pixels() const { return sampled + interpolated + traced; }
};

Totals totals_of(const FrameOutcome& outcome);

/// Whether a counter of this name is a largest value, which is not added up.
bool is_peak(const std::string& name);

/// Adds up; an interval's ends too, since the errors of frames need not be independent.  Counters that are
/// peaks keep the larger value.
void add(Totals& sum, const Totals& frame);

/// Of a frame or the sum of frames; without what the fidelity does not have.
std::vector<Number> frame_numbers(const Totals& totals);
/// Over all frames, at the configured clock.
std::vector<Number> derived_numbers(const Totals& totals, std::uint32_t clock_mhz);
/// Wall times and memory of the simulation: the only numbers that differ from run to run.  `golden_seconds` below 0: no
/// check.
std::vector<Number> simulation_numbers(const Totals& totals, double golden_seconds);

/// As in stats.txt.
std::string value_text(const Number& number);

}  // namespace artu::sim
