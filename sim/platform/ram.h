// The platform's memory: a port for the processor, one for the unit.
//
// To the processor it answers at once (loosely timed); to the unit with the base protocol's four phases: a request ends
// `accept_time` after it came, its answer begins `latency` after it, answers in the order of their requests.
#pragma once

#include <tlm_utils/peq_with_cb_and_phase.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstdint>
#include <deque>
#include <vector>

namespace artu::sim {

class Ram : public sc_core::sc_module {
 public:
  Ram(sc_core::sc_module_name name, std::uint64_t base, std::uint64_t bytes, const sc_core::sc_time& accept_time,
      const sc_core::sc_time& latency);
  tlm_utils::simple_target_socket<Ram, 64> processor_port, unit_port;

  std::uint64_t reads() const { return reads_; }    // of the unit
  std::uint64_t writes() const { return writes_; }  // of the unit

 private:
  using Payload = tlm::tlm_generic_payload;
  bool access(Payload& payload);
  void b_transport(Payload& payload, sc_core::sc_time& delay);
  unsigned transport_dbg(Payload& payload);
  tlm::tlm_sync_enum nb_transport_fw(Payload& payload, tlm::tlm_phase& phase, sc_core::sc_time& delay);
  void due(Payload& payload, const tlm::tlm_phase& phase);
  void respond();

  const std::uint64_t base_;
  const sc_core::sc_time accept_time_, latency_;
  std::vector<std::uint8_t> bytes_;
  tlm_utils::peq_with_cb_and_phase<Ram> queue_;
  std::deque<Payload*> answers_;
  bool responding_ = false;
  std::uint64_t reads_ = 0, writes_ = 0;
};

}  // namespace artu::sim
