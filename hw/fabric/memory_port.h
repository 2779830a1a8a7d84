// How blocks talk to memory: a request channel down, a response channel up.
#pragma once

#include "hw/fabric/fifo.h"
#include "hw/memory/layout.h"

namespace artu::hw {

/// One line.  Timing only: the bytes are in the memory image, which a block reads when the response is there.
struct MemoryRequest {
  Address line = 0;          // address of the line
  std::uint64_t bytes = 0;   // write: which bytes of the line; 0 = read
  std::uint32_t tag = 0;     // given back in the response
  std::uint16_t source = 0;  // filled by the interconnect, to route the response
  bool write() const { return bytes != 0; }
};

struct MemoryResponse {
  std::uint32_t tag = 0;
  std::uint16_t source = 0;
};

inline constexpr Address line_bytes = 64;
inline Address line_of(Address address) { return address & ~(line_bytes - 1); }

/// The two channels between a block that asks and a memory that answers.
struct MemoryLink {
  MemoryLink(const std::string& name, std::uint32_t depth, std::uint32_t request_latency,
             std::uint32_t response_latency)
      : request(name + ".request", depth + request_latency, request_latency),
        response(name + ".response", depth + response_latency, response_latency) {}
  void bind(Block& requester, Block& memory) {
    request.bind(requester, memory);
    response.bind(memory, requester);
  }
  Fifo<MemoryRequest> request;
  Fifo<MemoryResponse> response;
};

}  // namespace artu::hw
