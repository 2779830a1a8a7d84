// The unit's control registers as software sees them (docs/tlm.md has the map), behind a TLM-2.0 target socket.
//
// In:  b_transport, transport_dbg (non-blocking calls are turned into blocking ones by the socket).
// Out: `start` when software starts a frame; `changed` when the interrupt may have.
// Latency: `access_time` of simulated time for an access, by the delay argument.   Stalls: none.
#pragma once

#include <cstdint>
#include <functional>
#include <systemc>
#include <tlm>
#include <vector>

namespace artu::hw {

/// Byte offsets; every register has 32 bits.
namespace control_register {
inline constexpr std::uint32_t id = 0x00, version = 0x04, control = 0x08, status = 0x0c, descriptor_lo = 0x10,
                               descriptor_hi = 0x14, cycles_lo = 0x18, cycles_hi = 0x1c, counters = 0x20,
                               counter_select = 0x24, counter_lo = 0x28, counter_hi = 0x2c, bytes = 0x30;
}  // namespace control_register

inline constexpr std::uint32_t register_id = 0x55545241;       // "ARTU", little-endian
inline constexpr std::uint32_t register_version = 0x00010000;  // of the map: major in the upper half
inline constexpr std::uint32_t control_start = 1, control_interrupt_enable = 2, control_clear = 4;
inline constexpr std::uint32_t status_running = 1, status_done = 2, status_error = 4, status_code_shift = 8;

/// Why a frame ended without a picture.
enum class FrameError : std::uint8_t {
  none,
  descriptor,       // it, or something that it points to, is not in the window, or not on a line; no debug access
  memory_response,  // the memory answered with an error
  memory_address,   // a line outside of the window was asked for
  dead_lock,        // the watchdog saw no token move
  accounting        // the picture is there, but an accounting law does not hold
};

class ControlRegisters {
 public:
  /// `start` is given the time from now at which the frame begins.
  ControlRegisters(const sc_core::sc_time& access_time, std::function<void(const sc_core::sc_time&)> start,
                   std::function<void()> changed);

  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  /// Reads any bytes, without effect; does not write.
  unsigned transport_dbg(tlm::tlm_generic_payload& payload) const;

  /// The frame is over; with an error there are no cycles and the counters are as they were.
  void finish(FrameError error, std::uint64_t cycles);
  void set_counters(std::vector<std::uint64_t> values) { counters_ = std::move(values); }
  std::uint64_t descriptor() const { return descriptor_; }
  bool running() const { return running_; }
  bool interrupt() const { return interrupt_enabled_ && (done_ || error_ != FrameError::none); }

 private:
  tlm::tlm_response_status access(tlm::tlm_generic_payload& payload, const sc_core::sc_time& end);
  tlm::tlm_response_status write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& end);
  void control(std::uint32_t value, const sc_core::sc_time& end);
  std::uint32_t read(std::uint32_t offset) const;
  std::uint32_t status() const;

  const sc_core::sc_time access_time_;
  const std::function<void(const sc_core::sc_time&)> start_;
  const std::function<void()> changed_;
  bool running_ = false, done_ = false, interrupt_enabled_ = false;
  FrameError error_ = FrameError::none;
  std::uint64_t descriptor_ = 0, cycles_ = 0;
  std::uint32_t select_ = 0;
  std::vector<std::uint64_t> counters_;
};

}  // namespace artu::hw
