// The platform's processor: the driver's steps for one frame, over TLM alone.
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <cstdint>
#include <string>
#include <vector>

#include "hw/memory/image.h"

namespace artu::sim {

class Processor : public sc_core::sc_module {
 public:
  /// `image` is what it copies to the memory at `base`; it stays the caller's.
  Processor(sc_core::sc_module_name name, const hw::MemoryImage& image, std::uint64_t base, hw::Address descriptor);
  tlm_utils::simple_initiator_socket<Processor, 64> memory;
  tlm_utils::simple_initiator_socket<Processor, 32> unit;
  sc_core::sc_in<bool> interrupt;

  // What it has found when the simulation is over.
  std::string complaint;                            // "" = none
  std::vector<std::uint8_t> frame_buffer, classes;  // as they lie in the memory
  std::uint64_t cycles = 0;                         // of the frame
  sc_core::sc_time frame_time;                      // from the start to the interrupt

 private:
  void program();
  void render();
  void copy(tlm::tlm_command command, std::uint64_t address, std::uint8_t* data, std::uint64_t bytes);
  void access(tlm::tlm_command command, std::uint32_t offset, unsigned char* data);
  std::uint32_t read(std::uint32_t offset);
  void write(std::uint32_t offset, std::uint32_t value);

  const hw::MemoryImage& image_;
  const std::uint64_t base_;
  const hw::Address descriptor_;
};

}  // namespace artu::sim
