#include "sim/platform/processor.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "hw/border/control_registers.h"

namespace artu::sim {

namespace reg = hw::control_register;

namespace {
constexpr std::uint64_t block_bytes = 4096;  // copied at a time
}

Processor::Processor(sc_core::sc_module_name name, const hw::MemoryImage& image, std::uint64_t base,
                     hw::Address descriptor)
    : sc_module(name),
      memory("memory"),
      unit("unit"),
      interrupt("interrupt"),
      image_(image),
      base_(base),
      descriptor_(descriptor) {
  SC_HAS_PROCESS(Processor);
  SC_THREAD(program);
}

void Processor::copy(tlm::tlm_command command, std::uint64_t address, std::uint8_t* data, std::uint64_t bytes) {
  for (std::uint64_t done = 0; done < bytes; done += block_bytes) {
    const auto length = static_cast<unsigned>(std::min(block_bytes, bytes - done));
    tlm::tlm_generic_payload payload;
    payload.set_command(command);
    payload.set_address(base_ + address + done);
    payload.set_data_ptr(data + done);
    payload.set_data_length(length);
    payload.set_streaming_width(length);
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    memory->b_transport(payload, delay);
    if (!payload.is_response_ok()) throw std::runtime_error("memory: " + payload.get_response_string());
    wait(delay);
  }
}

void Processor::access(tlm::tlm_command command, std::uint32_t offset, unsigned char* data) {
  tlm::tlm_generic_payload payload;
  payload.set_command(command);
  payload.set_address(offset);
  payload.set_data_ptr(data);
  payload.set_data_length(4);
  payload.set_streaming_width(4);
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  unit->b_transport(payload, delay);
  if (!payload.is_response_ok()) throw std::runtime_error("register: " + payload.get_response_string());
  wait(delay);
}

std::uint32_t Processor::read(std::uint32_t offset) {
  unsigned char data[4];
  access(tlm::TLM_READ_COMMAND, offset, data);
  return data[0] | data[1] << 8 | data[2] << 16 | static_cast<std::uint32_t>(data[3]) << 24;
}

void Processor::write(std::uint32_t offset, std::uint32_t value) {
  unsigned char data[4];
  for (int i = 0; i < 4; ++i) data[i] = static_cast<unsigned char>(value >> (8 * i));
  access(tlm::TLM_WRITE_COMMAND, offset, data);
}

void Processor::program() {
  try {
    render();
  } catch (const std::runtime_error& error) {
    complaint = error.what();
  }
}

void Processor::render() {
  if (read(reg::id) != hw::register_id) throw std::runtime_error("no ray-tracing unit here");
  if (read(reg::version) >> 16 != hw::register_version >> 16) throw std::runtime_error("another register map");

  // The driver has made the image; the processor only copies it.  Nothing lies below address 64.
  auto* bytes = const_cast<std::uint8_t*>(&image_.at<std::uint8_t>(0));
  copy(tlm::TLM_WRITE_COMMAND, 64, bytes + 64, image_.size() - 64);

  write(reg::descriptor_lo, static_cast<std::uint32_t>(descriptor_));
  write(reg::descriptor_hi, static_cast<std::uint32_t>(descriptor_ >> 32));
  write(reg::control, hw::control_start | hw::control_interrupt_enable);
  // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): a reference would go on with the time.
  const sc_core::sc_time start = sc_core::sc_time_stamp();
  if (!interrupt.read()) wait(interrupt.posedge_event());
  frame_time = sc_core::sc_time_stamp() - start;

  const std::uint32_t status = read(reg::status);
  if (status != hw::status_done) throw std::runtime_error(fmt::format("the frame ended with status {:#x}", status));
  cycles = read(reg::cycles_lo) | static_cast<std::uint64_t>(read(reg::cycles_hi)) << 32;
  write(reg::control, hw::control_clear);

  const auto& frame = image_.at<hw::FrameDescriptor>(descriptor_);
  const std::uint64_t pixels = std::uint64_t{frame.pitch} * frame.height;
  frame_buffer.resize(pixels * 4);
  classes.resize(pixels);
  copy(tlm::TLM_READ_COMMAND, frame.frame_buffer, frame_buffer.data(), frame_buffer.size());
  copy(tlm::TLM_READ_COMMAND, frame.hit_classes, classes.data(), classes.size());
}

}  // namespace artu::sim
