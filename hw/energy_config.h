// Energy of events, for reports: no block reads it, and it changes no cycle and no pixel (docs/energy.md has the
// sources).
#pragma once

#include "hw/fabric/parameter.h"

namespace artu::hw {

/// Of binary32; docs/energy.md has the law for narrower formats.
struct OperatorEnergy {
  float add = 0.9f, multiply = 3.7f, divide = 26.3f, square_root = 26.3f, compare = 0.1f, integer = 0.03f;
  float multiply_overhead = 0.11f;
  void visit(ParameterVisitor& v);
};

struct SramEnergy {
  float access = 10.0f, growth = 1.39f;
  void visit(ParameterVisitor& v);
};

struct WireEnergy {
  float registers = 0.25f, wire = 1.6f;
  float core_length = 0.7f, chip_length = 2.1f;
  void visit(ParameterVisitor& v);
};

struct LeakagePower {
  float core = 23.0f, sram = 0.02f;
  void visit(ParameterVisitor& v);
};

/// A channel of LPDDR4-3200.
struct DramEnergy {
  float activate = 1205.0f, read = 67.8f, write = 40.3f, refresh = 22400.0f, background = 37.9f;
  void visit(ParameterVisitor& v);
};

struct EnergyConfig {
  float scale = 0.53f;
  float build = 4000.0f;
  OperatorEnergy operators;
  SramEnergy sram;
  WireEnergy wires;
  LeakagePower leakage;
  DramEnergy dram;
  void visit(ParameterVisitor& v);
};

}  // namespace artu::hw
