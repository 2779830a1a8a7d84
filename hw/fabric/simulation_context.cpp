#include "hw/fabric/simulation_context.h"

#include <algorithm>
#include <vector>

namespace artu::hw {

namespace {

/// Those that live, the oldest first.  They need not end in the reverse order.
std::vector<sc_core::sc_simcontext*>& living() {
  static std::vector<sc_core::sc_simcontext*> all;
  return all;
}

/// Without a context SystemC makes one where it needs it.
void make_current(sc_core::sc_simcontext* context) {
  sc_core::sc_curr_simcontext = sc_core::sc_default_global_context = context;
}

}  // namespace

SimulationContext::SimulationContext() : own_(new sc_core::sc_simcontext) {
  living().push_back(own_);
  enter();
}

SimulationContext::~SimulationContext() {
  auto& all = living();
  all.erase(std::remove(all.begin(), all.end(), own_), all.end());
  sc_core::sc_simcontext* next = sc_core::sc_curr_simcontext;
  if (next == own_) next = all.empty() ? nullptr : all.back();
  enter();  // its processes end in it; without a current one SystemC would make another
  delete own_;
  make_current(next);
}

void SimulationContext::enter() { make_current(own_); }

}  // namespace artu::hw
