#include "sim/driver/fidelity.h"

#include <array>

#include "traces/error.h"

namespace artu::sim {
namespace {

struct Mode {
  const char* name;
  const char* promise;
};

constexpr std::array<Mode, fidelity_count> modes{{
    {"functional", "pixels and counts exact, no cycles"},
    {"analytic", "pixels and counts exact; cycles and DRAM bytes estimated"},
    {"sampled", "all figures estimated from some of the frames"},
    {"event", "all exact"},
    {"clocked", "all exact"},
}};

}  // namespace

const char* fidelity_name(Fidelity fidelity) { return modes[static_cast<std::size_t>(fidelity)].name; }

const char* promise_of(Fidelity fidelity) { return modes[static_cast<std::size_t>(fidelity)].promise; }

Fidelity parse_fidelity(const std::string& name) {
  std::string all;
  for (std::size_t i = 0; i < fidelity_count; ++i) {
    if (name == modes[i].name) return static_cast<Fidelity>(i);
    all += (i == 0 ? "" : i + 1 == fidelity_count ? " or " : ", ") + std::string(modes[i].name);
  }
  throw InputError("--fidelity", "\"" + name + "\" is none; " + all + " would be right");
}

}  // namespace artu::sim
