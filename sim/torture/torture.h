// Units and scenes drawn at random, simulated with random stalls: every bit against the golden model, every law.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/driver/frame_simulator.h"
#include "sim/torture/drawn_scene.h"

namespace artu::sim {

/// Follows from its seed alone.
struct TortureCase {
  std::uint64_t seed = 0;
  std::vector<std::string> assignments;  // of the unit: path=value
  SceneRecipe scene;
  SimulationOptions simulation;
  bool clocked_too = false;  // the same counters with every block ticked in every cycle
};

TortureCase draw_case(std::uint64_t seed);

enum class Verdict : std::uint8_t {
  fine,
  refused,   // unit and scene do not go together, and one line says so
  mismatch,  // with the golden model, or of event and clocked
  unlawful,  // an accounting law is violated
  dead_lock,
  exception,  // anything else that was thrown
};
inline constexpr std::size_t verdict_count = 6;
const char* verdict_name(Verdict verdict);
inline bool is_failure(Verdict verdict) { return verdict != Verdict::fine && verdict != Verdict::refused; }

struct TortureResult {
  Verdict verdict = Verdict::fine;
  std::string text;  // of what is not fine
  std::uint64_t pixels = 0, cycles = 0;
};

TortureResult run_case(const TortureCase& drawn);

/// The fewest assignments and the smallest scene that still end in `verdict` (delta debugging: Zeller and Hildebrandt,
/// "Simplifying and Isolating Failure-Inducing Input", 2002, with one assignment or number at a time).
TortureCase shrink(TortureCase failing, Verdict verdict);

}  // namespace artu::sim
