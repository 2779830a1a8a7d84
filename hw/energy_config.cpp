#include "hw/energy_config.h"

namespace artu::hw {

void OperatorEnergy::visit(ParameterVisitor& v) {
  v.real("add", add, {0, 1000}, "pJ", "an addition or subtraction in binary32, at 45 nm");
  v.real("multiply", multiply, {0, 1000}, "pJ", "a multiplication in binary32, at 45 nm");
  v.real("multiply_overhead", multiply_overhead, {0, 1}, "",
         "share of it that a narrower significand does not save: exponent and rounding");
  v.real("divide", divide, {0, 10000}, "pJ", "a division in binary32, at 45 nm");
  v.real("square_root", square_root, {0, 10000}, "pJ", "a square root in binary32, at 45 nm");
  v.real("compare", compare, {0, 1000}, "pJ", "a comparison, minimum or maximum in binary32, at 45 nm");
  v.real("integer", integer, {0, 1000}, "pJ", "an 8-bit integer operation, at 45 nm");
}

void SramEnergy::visit(ParameterVisitor& v) {
  v.real("access", access, {0, 10000}, "pJ", "64 bits read from or written to an array of 8 KiB, at 45 nm");
  v.real("growth", growth, {1, 2}, "", "factor for each doubling of the array");
}

void WireEnergy::visit(ParameterVisitor& v) {
  v.real("registers", registers, {0, 1000}, "pJ/byte", "read from or written to contexts and stacks");
  v.real("wire", wire, {0, 1000}, "pJ/byte/mm", "moved on the chip");
  v.real("core_length", core_length, {0, 100}, "mm", "between a block and its L1 cache");
  v.real("chip_length", chip_length, {0, 100}, "mm", "between a core and the L2, and from the L2 to the DRAM's pins");
}

void LeakagePower::visit(ParameterVisitor& v) {
  v.real("core", core, {0, 10000}, "mW", "a ray core without its caches");
  v.real("sram", sram, {0, 1000}, "mW/KiB", "the caches");
}

void DramEnergy::visit(ParameterVisitor& v) {
  v.real("activate", activate, {0, 100000}, "pJ", "a row opened and closed");
  v.real("read", read, {0, 10000}, "pJ/byte", "read in bursts, with the interface");
  v.real("write", write, {0, 10000}, "pJ/byte", "written in bursts, with the interface");
  v.real("refresh", refresh, {0, 10000000}, "pJ", "refresh of all banks; of one bank its share");
  v.real("background", background, {0, 10000}, "mW", "a channel that is not powered down");
}

void EnergyConfig::visit(ParameterVisitor& v) {
  v.real("scale", scale, {0, 100}, "", "from 45 nm to the unit's process: on operators, sram and build");
  v.real("build", build, {0, 10000000}, "pJ", "a triangle in the tree builder, all levels, at 45 nm");
  v.enter("operators", "operators of the datapaths");
  operators.visit(v);
  v.leave();
  v.enter("sram", "arrays of the caches");
  sram.visit(v);
  v.leave();
  v.enter("wires", "registers and wires, of the unit's process");
  wires.visit(v);
  v.leave();
  v.enter("leakage", "static power, of the unit's process");
  leakage.visit(v);
  v.leave();
  v.enter("dram", "a channel of the DRAM");
  dram.visit(v);
  v.leave();
}

}  // namespace artu::hw
