#include "hw/border/tlm_memory_bridge.h"

#include <algorithm>

namespace artu::hw {

TlmMemoryBridge::TlmMemoryBridge(sc_core::sc_module_name name, ClockDomain& domain, MemoryImage& image,
                                 const TlmWindow& window)
    : MainMemory(name, domain), socket("socket"), image_(image), window_(window) {
  socket.register_nb_transport_bw(this, &TlmMemoryBridge::nb_transport_bw);
}

/// A frame begins: nothing is under way, since the one before was drained.
void TlmMemoryBridge::reset() {
  events_.clear();
  answers_.clear();
  request_ = nullptr;
  drained_ = nullptr;
  draining_ = false;
  outstanding_ = 0;
  failure_ = Failure::none;
  failed_at_ = 0;
  reads_ = writes_ = 0;
}

bool TlmMemoryBridge::load(Address begin, std::uint64_t bytes) {
  if (bytes == 0) return true;
  tlm::tlm_generic_payload payload;
  payload.set_command(tlm::TLM_READ_COMMAND);
  payload.set_address(window_.base + begin);
  payload.set_data_ptr(&image_.at<std::uint8_t>(begin));
  payload.set_data_length(static_cast<unsigned>(bytes));
  payload.set_streaming_width(static_cast<unsigned>(bytes));
  return socket->transport_dbg(payload) == bytes;
}

bool TlmMemoryBridge::produced(Address line) const {
  return std::any_of(produced_.begin(), produced_.end(),
                     [line](const Range& range) { return line >= range.begin && line < range.end; });
}

void TlmMemoryBridge::fail(Failure why, Address line) {
  if (failure_ != Failure::none) return;
  failure_ = why;
  failed_at_ = line;
  domain().finish();
}

/// Notes what the memory says, for the first cycle after it.
void TlmMemoryBridge::note(LineTransaction& transaction, bool response, const sc_core::sc_time& delay) {
  const Cycle cycle = domain().first_cycle_after(sc_core::sc_time_stamp() + delay);
  events_.insert({cycle, {&transaction, response}});
  domain().wake(*this, cycle);
}

tlm::tlm_sync_enum TlmMemoryBridge::nb_transport_bw(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase,
                                                    sc_core::sc_time& delay) {
  auto& transaction = static_cast<LineTransaction&>(payload);
  const bool response = phase == tlm::BEGIN_RESP;
  if (!response && phase != tlm::END_REQ) return tlm::TLM_ACCEPTED;  // phases of other protocols may be ignored
  if (!draining_) {
    note(transaction, response, delay);
    return tlm::TLM_ACCEPTED;
  }
  if (!response) return tlm::TLM_ACCEPTED;
  transaction.ended = true;
  end(transaction);
  if (outstanding_ == 0) drained_();
  return tlm::TLM_COMPLETED;
}

/// The answer is taken: the response phase ends.
void TlmMemoryBridge::end(LineTransaction& transaction) {
  if (!transaction.ended) {
    tlm::tlm_phase phase = tlm::END_RESP;
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket->nb_transport_fw(transaction, phase, delay);
  }
  --outstanding_;
  transaction.release();
}

void TlmMemoryBridge::drain(std::function<void()> done) {
  draining_ = true;
  drained_ = std::move(done);
  for (const auto& [cycle, event] : events_) {
    if (event.response) answers_.push_back(event.transaction);
  }
  events_.clear();
  while (!answers_.empty()) {
    LineTransaction& transaction = *answers_.front();
    answers_.pop_front();
    end(transaction);
  }
  if (outstanding_ == 0) drained_();
}

/// (1) What the memory has said.
bool TlmMemoryBridge::hear(Cycle now) {
  bool heard = false;
  while (!events_.empty() && events_.begin()->first <= now) {
    const Event event = events_.begin()->second;
    events_.erase(events_.begin());
    if (request_ == event.transaction) request_ = nullptr;  // BEGIN_RESP says END_REQ as well
    if (event.response) answers_.push_back(event.transaction);
    heard = true;
  }
  return heard;
}

/// (2) One answer to the L2.
bool TlmMemoryBridge::answer(bool& blocked) {
  if (answers_.empty()) return false;
  if (!link_->response.can_push()) {
    blocked = true;
    return false;
  }
  LineTransaction& transaction = *answers_.front();
  const MemoryRequest request = transaction.request;
  const bool fine = transaction.is_response_ok();
  if (fine && !request.write() && !produced(request.line)) {
    std::copy(transaction.data.begin(), transaction.data.end(), &image_.at<std::uint8_t>(request.line));
  }
  answers_.pop_front();
  end(transaction);
  if (fine) {
    link_->response.push({request.tag, request.source});
  } else {
    fail(Failure::response, request.line);
  }
  return true;
}

void TlmMemoryBridge::begin(LineTransaction& transaction) {
  request_ = &transaction;
  ++outstanding_;
  tlm::tlm_phase phase = tlm::BEGIN_REQ;
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  switch (socket->nb_transport_fw(transaction, phase, delay)) {
    case tlm::TLM_ACCEPTED:
      break;
    case tlm::TLM_UPDATED:
      note(transaction, phase == tlm::BEGIN_RESP, delay);
      break;
    case tlm::TLM_COMPLETED:
      transaction.ended = true;
      note(transaction, true, delay);
      break;
  }
}

/// (3) The next request to the memory.
bool TlmMemoryBridge::ask() {
  if (request_ != nullptr || failure_ != Failure::none || !link_->request.can_pop()) return false;
  const MemoryRequest request = link_->request.front();
  link_->request.pop();
  if (!inside(request.line, line_bytes)) {
    fail(Failure::address, request.line);
    return true;
  }
  ++(request.write() ? writes_ : reads_);
  LineTransaction& transaction = pool_.acquire(request, window_.base + request.line);
  if (request.write()) {
    const std::uint8_t* bytes = &image_.at<std::uint8_t>(request.line);
    std::copy(bytes, bytes + line_bytes, transaction.data.begin());
  }
  begin(transaction);
  return true;
}

Activity TlmMemoryBridge::tick(Cycle now) {
  bool blocked = false;
  bool moved = hear(now);
  moved = answer(blocked) || moved;
  moved = ask() || moved;
  const bool more = (!answers_.empty() && (moved || !blocked)) || (link_->request.can_pop() && request_ == nullptr);
  if (blocked && !moved) return {State::stall_out};
  // As the built-in DRAM, it is busy while the memory works for it.
  if (outstanding_ != 0) return {State::busy, more ? now + 1 : never};
  if (moved) return more ? Activity(State::busy, now + 1) : Activity::once(State::busy, State::stall_in);
  return {State::stall_in};
}

void TlmMemoryBridge::report(Statistics& out) const {
  const std::string block = path();
  out.push_back({block, "read_bytes", read_bytes(), "bytes", "read from the memory outside"});
  out.push_back({block, "write_bytes", write_bytes(), "bytes", "written to the memory outside"});
}

std::string TlmMemoryBridge::describe() const {
  return std::to_string(outstanding_) + " transactions outstanding" +
         (request_ != nullptr ? ", the memory has not ended a request" : "");
}

}  // namespace artu::hw
