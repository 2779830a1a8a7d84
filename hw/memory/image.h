// The unit's memory, flat: records are laid down by the driver and read where they lie.
#pragma once

#include <cstring>
#include <vector>

#include "hw/memory/layout.h"

namespace artu::hw {

class MemoryImage {
 public:
  /// Room for `bytes`, zeroed, on a line boundary; returns its address.  Address 0 is never given out.
  Address allocate(std::uint64_t bytes);
  std::uint64_t size() const { return top_; }
  /// Frees everything allocated since size() was `top`.
  void shrink(std::uint64_t top) { top_ = top; }

  template <class Record>
  const Record& at(Address address) const {
    return *reinterpret_cast<const Record*>(base() + address);
  }
  template <class Record>
  Record& at(Address address) {
    return *reinterpret_cast<Record*>(base() + address);
  }

 private:
  struct alignas(64) Line {
    std::uint8_t bytes[64];
  };
  std::uint8_t* base() { return reinterpret_cast<std::uint8_t*>(lines_.data()); }
  const std::uint8_t* base() const { return reinterpret_cast<const std::uint8_t*>(lines_.data()); }

  std::vector<Line> lines_;
  std::uint64_t top_ = 64;
};

}  // namespace artu::hw
