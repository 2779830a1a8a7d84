// The transactions of the unit's memory port: one line each, reused.
//
// A transaction belongs to whoever holds a reference (TLM-2.0, memory management): it comes back to the pool when the
// last one is released, which may be after the unit has its answer.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <tlm>
#include <vector>

#include "hw/fabric/memory_port.h"

namespace artu::hw {

/// A generic payload with its bytes, and what the answer needs.
struct LineTransaction : public tlm::tlm_generic_payload {
  explicit LineTransaction(tlm::tlm_mm_interface* pool) : tlm_generic_payload(pool) {}
  MemoryRequest request;
  bool ended = false;  // the memory said TLM_COMPLETED: there is no END_RESP
  std::array<std::uint8_t, line_bytes> data{}, enables{};
};

class TlmPayloadPool : public tlm::tlm_mm_interface {
 public:
  /// A read or a write of a line, complete but for the data of a write; held once.
  LineTransaction& acquire(const MemoryRequest& request, std::uint64_t address);
  void free(tlm::tlm_generic_payload* transaction) override;
  /// How many there are, in use or not.
  std::size_t size() const { return all_.size(); }
  std::size_t in_use() const { return all_.size() - unused_.size(); }

 private:
  std::vector<std::unique_ptr<LineTransaction>> all_;
  std::vector<LineTransaction*> unused_;
};

}  // namespace artu::hw
