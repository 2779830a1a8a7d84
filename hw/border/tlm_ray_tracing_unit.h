// The unit with TLM-2.0 at its border, for a virtual platform: control registers, memory, an interrupt.
//
// In:  `registers` (docs/tlm.md has the map): software writes the descriptor's address and starts a frame.
// Out: `memory`: every line that the L2 fetches or writes back (hw/border/tlm_memory_bridge.h); `interrupt`, a level:
//      high from the end of a frame until software clears it, where it is enabled.
// Time: SystemC's at the border, integer cycles inside.  Cycle 0 of a frame is when the access that starts it ends; the
// frame's last cycle is when the status and the interrupt change.  Between frames the unit costs nothing.
//
// The unit computes on an image of the memory's window.  It comes with the read responses, but for what the model reads
// or overwrites without asking: the descriptor, the lights, and the lines that the unit produces (frame buffer, hit
// classes, the dynamic tree where it is to be built), which come through the debug transport when a frame starts.
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include "hw/border/control_registers.h"
#include "hw/border/tlm_memory_bridge.h"
#include "hw/ray_tracing_unit.h"

namespace artu::hw {

class TlmRayTracingUnit : public sc_core::sc_module {
 public:
  TlmRayTracingUnit(sc_core::sc_module_name name, const UnitConfig& config, const RunMode& mode,
                    const TlmWindow& window);

 private:
  MemoryImage image_;
  TlmMemoryBridge* bridge_ = nullptr;  // of unit_
  RayTracingUnit unit_;
  const bool skip_rebuild_;

 public:
  tlm_utils::simple_target_socket<TlmRayTracingUnit, 32> registers;
  tlm_utils::simple_initiator_socket<TlmMemoryBridge, 64>& memory;
  sc_core::sc_out<bool> interrupt;

  /// What the performance counters are, "block.name", in the order of their numbers.
  std::vector<std::string> counter_names();
  /// For a host that checks pixels, width * height of the frames to come; null: none.
  void observe(PixelRecords* records) { records_ = records; }
  /// All there is to know of the last frame that was started.
  const FrameResult& result() const { return result_; }

 private:
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) { control_.b_transport(payload, delay); }
  unsigned transport_dbg(tlm::tlm_generic_payload& payload) { return control_.transport_dbg(payload); }
  void begin();
  void end();
  void drive() { interrupt.write(control_.interrupt()); }
  bool fetch_descriptor();
  bool load(Address begin, std::uint64_t bytes);
  bool take_over(Address begin, std::uint64_t bytes);
  FrameError error_of(const FrameResult& result) const;
  void count(const Statistics& statistics);

  ControlRegisters control_;
  PixelRecords* records_ = nullptr;
  FrameResult result_;
  sc_core::sc_event begin_, end_, changed_;
};

}  // namespace artu::hw
