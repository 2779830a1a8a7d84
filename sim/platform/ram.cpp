#include "sim/platform/ram.h"

#include <cstring>

namespace artu::sim {

Ram::Ram(sc_core::sc_module_name name, std::uint64_t base, std::uint64_t bytes, const sc_core::sc_time& accept_time,
         const sc_core::sc_time& latency)
    : sc_module(name),
      processor_port("processor_port"),
      unit_port("unit_port"),
      base_(base),
      accept_time_(accept_time),
      latency_(latency),
      bytes_(bytes),
      queue_(this, &Ram::due) {
  processor_port.register_b_transport(this, &Ram::b_transport);
  processor_port.register_transport_dbg(this, &Ram::transport_dbg);
  unit_port.register_nb_transport_fw(this, &Ram::nb_transport_fw);
  unit_port.register_transport_dbg(this, &Ram::transport_dbg);
}

bool Ram::access(Payload& payload) {
  const std::uint64_t offset = payload.get_address() - base_;
  const unsigned length = payload.get_data_length();
  if (payload.get_address() < base_ || offset > bytes_.size() || length > bytes_.size() - offset) {
    payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    return false;
  }
  if (payload.is_read()) {
    std::memcpy(payload.get_data_ptr(), &bytes_[offset], length);
  } else if (payload.is_write()) {
    const unsigned char* enables = payload.get_byte_enable_ptr();
    for (unsigned i = 0; i < length; ++i) {
      const bool enabled = enables == nullptr || enables[i % payload.get_byte_enable_length()] == TLM_BYTE_ENABLED;
      if (enabled) bytes_[offset + i] = payload.get_data_ptr()[i];
    }
  }
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
  return true;
}

void Ram::b_transport(Payload& payload, sc_core::sc_time& delay) {
  delay += latency_;
  access(payload);
}

unsigned Ram::transport_dbg(Payload& payload) { return access(payload) ? payload.get_data_length() : 0; }

tlm::tlm_sync_enum Ram::nb_transport_fw(Payload& payload, tlm::tlm_phase& phase, sc_core::sc_time& delay) {
  if (phase == tlm::BEGIN_REQ) {
    payload.acquire();
    queue_.notify(payload, tlm::END_REQ, delay + accept_time_);
    queue_.notify(payload, tlm::BEGIN_RESP, delay + accept_time_ + latency_);
    return tlm::TLM_ACCEPTED;
  }
  queue_.notify(payload, phase, delay);  // END_RESP
  return tlm::TLM_ACCEPTED;
}

void Ram::due(Payload& payload, const tlm::tlm_phase& phase) {
  if (phase == tlm::BEGIN_RESP) {
    ++(payload.is_write() ? writes_ : reads_);
    access(payload);
    answers_.push_back(&payload);
    respond();
  } else if (phase == tlm::END_RESP) {
    responding_ = false;
    payload.release();
    respond();
  } else {
    tlm::tlm_phase end = tlm::END_REQ;
    sc_core::sc_time now = sc_core::SC_ZERO_TIME;
    unit_port->nb_transport_bw(payload, end, now);
  }
}

/// One answer at a time, until the unit has taken it.
void Ram::respond() {
  while (!responding_ && !answers_.empty()) {
    Payload& payload = *answers_.front();
    answers_.pop_front();
    tlm::tlm_phase phase = tlm::BEGIN_RESP;
    sc_core::sc_time now = sc_core::SC_ZERO_TIME;
    if (unit_port->nb_transport_bw(payload, phase, now) == tlm::TLM_COMPLETED) {
      payload.release();
    } else {
      responding_ = true;
    }
  }
}

}  // namespace artu::sim
