// The unit's memory, flat: records are laid down by the driver and read where they lie.
#pragma once

#include <cstring>

#include "hw/memory/layout.h"

namespace artu::hw {

class MemoryImage {
 public:
  MemoryImage() = default;
  MemoryImage(const MemoryImage& other);
  MemoryImage& operator=(const MemoryImage&) = delete;
  ~MemoryImage();

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
  static constexpr std::size_t alignment = 64;
  std::uint8_t* base() { return base_; }
  const std::uint8_t* base() const { return base_; }
  void grow(std::uint64_t bytes);

  void* block_ = nullptr;  // of malloc: it grows by realloc, which moves pages and does not copy gigabytes
  std::uint8_t* base_ = nullptr;
  std::uint64_t capacity_ = 0, top_ = 64;
};

}  // namespace artu::hw
