// A SystemC simulation of its own.  SystemC has one current context at a time, into which modules are made and which
// sc_start runs; with one of these each, a process can hold many units, one after the other or side by side.
#pragma once

#include <systemc>

namespace artu::hw {

class SimulationContext {
 public:
  /// Is the current one from here on.
  SimulationContext();
  /// All modules of the context must be gone.  If it is the current one, the youngest of the others follows it.
  ~SimulationContext();
  SimulationContext(const SimulationContext&) = delete;
  SimulationContext& operator=(const SimulationContext&) = delete;

  /// Makes it the current one.
  void enter();

 private:
  sc_core::sc_simcontext* own_;
};

}  // namespace artu::hw
