// How closely the unit is modelled: run time against what is known of the frame.  docs/fidelity.md has what each
// promises.
#pragma once

#include <cstdint>
#include <string>

namespace artu::sim {

enum class Fidelity : std::uint8_t {
  functional,  // the picture and the counts; no time
  analytic,    // the same, and cycles estimated from what the counts demand of every resource
  sampled,     // of a sequence: all figures estimated from some of its frames
  event,       // every cycle in which a block has something to do
  clocked,     // every block in every cycle: the same cycles
};
inline constexpr std::size_t fidelity_count = 5;

/// As on the command line.
const char* fidelity_name(Fidelity fidelity);
/// Throws InputError for a name that is none.
Fidelity parse_fidelity(const std::string& name);

/// Every cycle of the frame is simulated: what a report says is exact for this model.
constexpr bool is_exact(Fidelity fidelity) { return fidelity == Fidelity::event || fidelity == Fidelity::clocked; }
/// FrameOutcome::cycles and all that follows from it is there, as an estimate or exact.
constexpr bool has_cycles(Fidelity fidelity) { return fidelity != Fidelity::functional; }
/// The counters of every block are there, so that the energy can be told.
constexpr bool has_energy(Fidelity fidelity) { return fidelity >= Fidelity::sampled; }

/// Half a line: what is exact, what is an estimate and what is not there.
const char* promise_of(Fidelity fidelity);

}  // namespace artu::sim
