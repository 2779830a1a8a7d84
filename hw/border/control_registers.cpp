#include "hw/border/control_registers.h"

#include <algorithm>

namespace artu::hw {

namespace at = control_register;

namespace {
std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }
std::uint32_t high(std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); }

// Little-endian on the bus, whatever the host is.
std::uint32_t value_of(const unsigned char* bytes) {
  return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}
unsigned char byte_of(std::uint32_t value, std::uint64_t offset) {
  return static_cast<unsigned char>(value >> (8 * (offset % 4)));
}
}  // namespace

ControlRegisters::ControlRegisters(const sc_core::sc_time& access_time,
                                   std::function<void(const sc_core::sc_time&)> start, std::function<void()> changed)
    : access_time_(access_time), start_(std::move(start)), changed_(std::move(changed)) {}

void ControlRegisters::b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  delay += access_time_;
  payload.set_response_status(access(payload, delay));
}

tlm::tlm_response_status ControlRegisters::access(tlm::tlm_generic_payload& payload, const sc_core::sc_time& end) {
  if (payload.get_command() == tlm::TLM_IGNORE_COMMAND) return tlm::TLM_OK_RESPONSE;
  if (payload.get_address() >= at::bytes || payload.get_address() % 4 != 0) return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  if (payload.get_data_length() != 4 || payload.get_streaming_width() < 4) return tlm::TLM_BURST_ERROR_RESPONSE;
  if (payload.get_byte_enable_ptr() != nullptr) return tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE;
  const auto offset = static_cast<std::uint32_t>(payload.get_address());
  unsigned char* data = payload.get_data_ptr();
  if (payload.is_write()) return write(offset, value_of(data), end);
  const std::uint32_t value = read(offset);
  for (std::uint32_t i = 0; i < 4; ++i) data[i] = byte_of(value, i);
  return tlm::TLM_OK_RESPONSE;
}

unsigned ControlRegisters::transport_dbg(tlm::tlm_generic_payload& payload) const {
  if (!payload.is_read() || payload.get_address() >= at::bytes) return 0;
  const auto begin = static_cast<std::uint32_t>(payload.get_address());
  const std::uint32_t count = std::min<std::uint32_t>(payload.get_data_length(), at::bytes - begin);
  for (std::uint32_t i = 0; i < count; ++i) {
    payload.get_data_ptr()[i] = byte_of(read((begin + i) & ~3u), begin + i);
  }
  return count;
}

std::uint32_t ControlRegisters::status() const {
  return (running_ ? status_running : 0) | (done_ ? status_done : 0) | (error_ != FrameError::none ? status_error : 0) |
         static_cast<std::uint32_t>(error_) << status_code_shift;
}

std::uint32_t ControlRegisters::read(std::uint32_t offset) const {
  const std::uint64_t counter = select_ < counters_.size() ? counters_[select_] : 0;
  switch (offset) {
    case at::id:
      return register_id;
    case at::version:
      return register_version;
    case at::control:
      return interrupt_enabled_ ? control_interrupt_enable : 0;
    case at::status:
      return status();
    case at::descriptor_lo:
      return low(descriptor_);
    case at::descriptor_hi:
      return high(descriptor_);
    case at::cycles_lo:
      return low(cycles_);
    case at::cycles_hi:
      return high(cycles_);
    case at::counters:
      return static_cast<std::uint32_t>(counters_.size());
    case at::counter_select:
      return select_;
    case at::counter_lo:
      return low(counter);
    case at::counter_hi:
      return high(counter);
    default:
      return 0;
  }
}

tlm::tlm_response_status ControlRegisters::write(std::uint32_t offset, std::uint32_t value,
                                                 const sc_core::sc_time& end) {
  switch (offset) {
    case at::control:
      control(value, end);
      return tlm::TLM_OK_RESPONSE;
    case at::descriptor_lo:
      descriptor_ = (descriptor_ & ~std::uint64_t{0xffffffff}) | value;
      return tlm::TLM_OK_RESPONSE;
    case at::descriptor_hi:
      descriptor_ = (descriptor_ & 0xffffffff) | std::uint64_t{value} << 32;
      return tlm::TLM_OK_RESPONSE;
    case at::counter_select:
      if (value >= counters_.size()) return tlm::TLM_GENERIC_ERROR_RESPONSE;
      select_ = value;
      return tlm::TLM_OK_RESPONSE;
    default:
      return tlm::TLM_COMMAND_ERROR_RESPONSE;  // read-only
  }
}

/// While a frame runs, only the enable bit counts.
void ControlRegisters::control(std::uint32_t value, const sc_core::sc_time& end) {
  interrupt_enabled_ = (value & control_interrupt_enable) != 0;
  if (!running_ && (value & (control_clear | control_start)) != 0) {
    done_ = false;
    error_ = FrameError::none;
  }
  if (!running_ && (value & control_start) != 0) {
    running_ = true;
    start_(end);
  }
  changed_();
}

void ControlRegisters::finish(FrameError error, std::uint64_t cycles) {
  running_ = false;
  done_ = error == FrameError::none || error == FrameError::accounting;
  error_ = error;
  cycles_ = done_ ? cycles : 0;
  changed_();
}

}  // namespace artu::hw
