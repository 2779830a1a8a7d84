// A TLM-2.0 memory with fixed latencies that watches whether its initiator keeps to the base protocol.
#pragma once

#include <tlm_utils/peq_with_cb_and_phase.h>
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstring>
#include <deque>
#include <functional>
#include <vector>

namespace artu::hw::test {

/// How it says that a request, and an answer, are there.
enum class TlmStyle {
  four_phases,  // TLM_ACCEPTED, then END_REQ and BEGIN_RESP on the backward path
  early_end,    // TLM_UPDATED with END_REQ, then BEGIN_RESP
  no_end,       // TLM_ACCEPTED, then BEGIN_RESP alone, which says END_REQ too
  response,     // TLM_UPDATED with BEGIN_RESP and its time
  completed     // TLM_COMPLETED with the time
};

class TestMemory : public sc_core::sc_module {
 public:
  TestMemory(sc_core::sc_module_name name, std::uint64_t base, std::uint64_t bytes, TlmStyle style)
      : sc_module(name), socket("socket"), bytes(bytes), base_(base), style_(style), queue_(this, &TestMemory::due) {
    socket.register_nb_transport_fw(this, &TestMemory::nb_transport_fw);
    socket.register_transport_dbg(this, &TestMemory::transport_dbg);
  }
  tlm_utils::simple_target_socket<TestMemory, 64> socket;
  std::vector<std::uint8_t> bytes;
  sc_core::sc_time latency = sc_core::SC_ZERO_TIME;                             // from BEGIN_REQ to BEGIN_RESP
  sc_core::sc_time accept = sc_core::SC_ZERO_TIME;                              // from BEGIN_REQ to END_REQ
  std::function<sc_core::sc_time(const tlm::tlm_generic_payload&)> latency_of;  // instead of `latency`
  std::function<tlm::tlm_response_status(const tlm::tlm_generic_payload&)> status_of;
  bool debug = true;

  std::vector<std::uint64_t> addresses;     // of the requests
  std::vector<sc_core::sc_time> requested;  // when they came
  std::uint64_t ended = 0;                  // responses that END_RESP has ended
  std::uint64_t breaches = 0;               // of the base protocol
  std::uint64_t debug_bytes = 0;

 private:
  using Payload = tlm::tlm_generic_payload;

  void work(Payload& p) {
    p.set_response_status(status_of ? status_of(p) : tlm::TLM_OK_RESPONSE);
    if (!p.is_response_ok()) return;
    std::uint8_t* here = &bytes.at(p.get_address() - base_);
    if (p.is_read()) {
      std::memcpy(p.get_data_ptr(), here, p.get_data_length());
      return;
    }
    for (unsigned i = 0; i < p.get_data_length(); ++i) {
      if (p.get_byte_enable_ptr() == nullptr || p.get_byte_enable_ptr()[i] == TLM_BYTE_ENABLED) {
        here[i] = p.get_data_ptr()[i];
      }
    }
  }

  tlm::tlm_sync_enum nb_transport_fw(Payload& p, tlm::tlm_phase& phase, sc_core::sc_time& delay) {
    if (phase == tlm::END_RESP) {
      if (responding_ != &p) ++breaches;
      responding_ = nullptr;
      ++ended;
      p.release();
      respond();
      return tlm::TLM_COMPLETED;
    }
    if (phase != tlm::BEGIN_REQ || requesting_ != nullptr) ++breaches;
    if (p.get_data_length() != 64 || p.get_streaming_width() != 64 || p.get_address() % 64 != 0) ++breaches;
    if (p.get_response_status() != tlm::TLM_INCOMPLETE_RESPONSE || delay != sc_core::SC_ZERO_TIME) ++breaches;
    addresses.push_back(p.get_address());
    requested.push_back(sc_core::sc_time_stamp());
    const sc_core::sc_time answer = latency_of ? latency_of(p) : latency;
    if (style_ == TlmStyle::completed || style_ == TlmStyle::response) {
      work(p);
      delay = answer;
      if (style_ == TlmStyle::completed) return tlm::TLM_COMPLETED;
      p.acquire();
      responding_ = &p;
      phase = tlm::BEGIN_RESP;
      return tlm::TLM_UPDATED;
    }
    p.acquire();
    queue_.notify(p, tlm::BEGIN_RESP, answer);
    if (style_ == TlmStyle::early_end) {
      phase = tlm::END_REQ;
      delay = accept;
      return tlm::TLM_UPDATED;
    }
    requesting_ = &p;
    if (style_ == TlmStyle::four_phases) queue_.notify(p, tlm::END_REQ, accept);
    return tlm::TLM_ACCEPTED;
  }

  void due(Payload& p, const tlm::tlm_phase& phase) {
    if (phase == tlm::END_REQ) {
      if (requesting_ != &p) return;  // BEGIN_RESP came first
      requesting_ = nullptr;
      send(p, tlm::END_REQ);
      return;
    }
    work(p);
    answers_.push_back(&p);
    respond();
  }

  /// One response phase at a time.
  void respond() {
    if (responding_ != nullptr || answers_.empty()) return;
    Payload& p = *answers_.front();
    answers_.pop_front();
    responding_ = &p;
    if (requesting_ == &p) requesting_ = nullptr;
    if (send(p, tlm::BEGIN_RESP) != tlm::TLM_COMPLETED) return;
    responding_ = nullptr;
    ++ended;
    p.release();
    respond();
  }

  tlm::tlm_sync_enum send(Payload& p, tlm::tlm_phase phase) {
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    return socket->nb_transport_bw(p, phase, delay);
  }

  unsigned transport_dbg(Payload& p) {
    if (!debug || p.get_address() < base_ || p.get_address() - base_ + p.get_data_length() > bytes.size()) return 0;
    std::memcpy(p.get_data_ptr(), &bytes[p.get_address() - base_], p.get_data_length());
    debug_bytes += p.get_data_length();
    return p.get_data_length();
  }

  const std::uint64_t base_;
  const TlmStyle style_;
  tlm_utils::peq_with_cb_and_phase<TestMemory> queue_;
  Payload* requesting_ = nullptr;
  Payload* responding_ = nullptr;
  std::deque<Payload*> answers_;
};

/// A processor's side of the control registers.
class TestHost : public sc_core::sc_module {
 public:
  explicit TestHost(sc_core::sc_module_name name) : sc_module(name), socket("socket") {}
  tlm_utils::simple_initiator_socket<TestHost, 32> socket;

  tlm::tlm_response_status access(tlm::tlm_command command, std::uint64_t address, std::uint32_t& value,
                                  unsigned length = 4, unsigned char* enables = nullptr, unsigned width = 4) {
    tlm::tlm_generic_payload p;
    p.set_command(command);
    p.set_address(address);
    p.set_data_ptr(reinterpret_cast<unsigned char*>(&value));
    p.set_data_length(length);
    p.set_streaming_width(width);
    p.set_byte_enable_ptr(enables);
    p.set_byte_enable_length(enables ? 4 : 0);
    socket->b_transport(p, delay);
    return p.get_response_status();
  }
  std::uint32_t read(std::uint64_t address) {
    std::uint32_t value = 0xdeadbeef;
    access(tlm::TLM_READ_COMMAND, address, value);
    return value;
  }
  tlm::tlm_response_status write(std::uint64_t address, std::uint32_t value) {
    return access(tlm::TLM_WRITE_COMMAND, address, value);
  }
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;  // of all accesses so far
};

}  // namespace artu::hw::test
