#include "hw/border/tlm_payload_pool.h"

namespace artu::hw {

LineTransaction& TlmPayloadPool::acquire(const MemoryRequest& request, std::uint64_t address) {
  if (unused_.empty()) {
    all_.push_back(std::make_unique<LineTransaction>(this));
    unused_.push_back(all_.back().get());
  }
  LineTransaction& t = *unused_.back();
  unused_.pop_back();
  t.acquire();
  t.request = request;
  t.ended = false;
  t.set_command(request.write() ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
  t.set_address(address);
  t.set_data_ptr(t.data.data());
  t.set_data_length(line_bytes);
  t.set_streaming_width(line_bytes);
  t.set_dmi_allowed(false);
  t.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  const bool partial = request.write() && request.bytes != ~std::uint64_t{0};
  t.set_byte_enable_ptr(partial ? t.enables.data() : nullptr);
  t.set_byte_enable_length(partial ? line_bytes : 0);
  if (partial) {
    for (std::size_t i = 0; i < line_bytes; ++i) {
      t.enables[i] = (request.bytes >> i & 1) != 0 ? TLM_BYTE_ENABLED : TLM_BYTE_DISABLED;
    }
  }
  return t;
}

void TlmPayloadPool::free(tlm::tlm_generic_payload* transaction) {
  transaction->reset();  // drops extensions that others have left
  unused_.push_back(static_cast<LineTransaction*>(transaction));
}

}  // namespace artu::hw
