// The unit's memory port: line requests of the L2 as TLM-2.0 transactions, instead of the built-in DRAM.
//
// In:  line requests from the L2, in the DRAM's clock domain.   Out: a response for each; for a write it says that the
//      memory has the data.   At `socket`: the base protocol, non-blocking, four phases, 64 bytes a transaction.
// A request goes out in the cycle in which it arrives, one a cycle, unless the memory has not ended the one before
// (END_REQ).  What the memory says at time t (its annotated delay included) is seen in the first cycle that begins
// after t; then the answer goes to the L2 and END_RESP to the memory, one a cycle.
// A memory that says nothing of END_REQ, or TLM_COMPLETED at once, ends a request with its answer.
// Latency: a memory that answers L after the request gives the L2 its line floor(L / period) + 1 cycles after it, and
// the cycle of the channel.   Initiation interval: 1.   Stalls: stall_out when the response channel is full.
//
// The bytes: the unit computes on its own image of the memory.  A read brings the memory's bytes into it before the
// response goes to the L2; a write takes them from it.  Lines that the unit itself produces (`produce`) are newer there
// than in the memory, so that reads leave them alone.
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <deque>
#include <functional>
#include <map>

#include "hw/border/tlm_payload_pool.h"
#include "hw/memory/image.h"
#include "hw/memory/main_memory.h"

namespace artu::hw {

/// Where the unit's memory lies on the bus: unit address a is bus address base + a, for 0 <= a < bytes.
struct TlmWindow {
  std::uint64_t base = 0, bytes = 0;
};

class TlmMemoryBridge : public MainMemory {
 public:
  enum class Failure : std::uint8_t { none, response, address };

  /// `image` has `window.bytes`.
  TlmMemoryBridge(sc_core::sc_module_name name, ClockDomain& domain, MemoryImage& image, const TlmWindow& window);
  tlm_utils::simple_initiator_socket<TlmMemoryBridge, 64> socket;

  void bind(MemoryLink& link) override { link_ = &link; }
  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;
  std::uint64_t read_bytes() const override { return reads_ * line_bytes; }
  std::uint64_t write_bytes() const override { return writes_ * line_bytes; }

  bool inside(Address begin, std::uint64_t bytes) const {
    return begin <= window_.bytes && bytes <= window_.bytes - begin;
  }
  /// Brings bytes into the image through the debug transport, in no time; false if the memory does not give them all.
  bool load(Address begin, std::uint64_t bytes);
  /// The unit itself writes these bytes, and lines that they lie in, until `produce_nothing`.
  void produce(Address begin, std::uint64_t bytes) { produced_.push_back({line_of(begin), begin + bytes}); }
  void produce_nothing() { produced_.clear(); }

  /// Why it ended the frame: an answer that was not TLM_OK_RESPONSE, or a line outside of the window.
  Failure failure() const { return failure_; }
  Address failed_at() const { return failed_at_; }
  /// After a frame that broke off: ends what is under way without a clock.  `done` is called when the last answer has
  /// come, at once if there is none to wait for.
  void drain(std::function<void()> done);

 private:
  struct Range {
    Address begin, end;
  };
  struct Event {
    LineTransaction* transaction;
    bool response;  // BEGIN_RESP, otherwise END_REQ
  };
  Activity tick(Cycle now) override;
  tlm::tlm_sync_enum nb_transport_bw(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase, sc_core::sc_time& delay);
  void note(LineTransaction& transaction, bool response, const sc_core::sc_time& delay);
  bool hear(Cycle now);
  bool answer(bool& blocked);
  bool ask();
  void begin(LineTransaction& transaction);
  void end(LineTransaction& transaction);
  void fail(Failure why, Address line);
  bool produced(Address line) const;

  MemoryImage& image_;
  const TlmWindow window_;
  MemoryLink* link_ = nullptr;
  TlmPayloadPool pool_;
  std::multimap<Cycle, Event> events_;  // by the cycle in which they are seen
  std::deque<LineTransaction*> answers_;
  LineTransaction* request_ = nullptr;  // whose request phase has not ended
  std::vector<Range> produced_;
  std::function<void()> drained_;
  bool draining_ = false;
  std::uint32_t outstanding_ = 0;
  Failure failure_ = Failure::none;
  Address failed_at_ = 0;
  std::uint64_t reads_ = 0, writes_ = 0;
};

}  // namespace artu::hw
