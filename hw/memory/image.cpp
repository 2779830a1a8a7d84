#include "hw/memory/image.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace artu::hw {

MemoryImage::MemoryImage(const MemoryImage& other) : top_(other.top_) {
  if (other.base_ == nullptr) return;
  grow(top_);
  std::memcpy(base_, other.base_, top_);
}

MemoryImage::~MemoryImage() { std::free(block_); }

/// Pages that nobody has touched yet are no memory, so there may be many.
void MemoryImage::grow(std::uint64_t bytes) {
  const std::uint64_t capacity = std::max(bytes, capacity_ + capacity_ / 4);
  const std::ptrdiff_t before = base_ - static_cast<std::uint8_t*>(block_);
  void* block = std::realloc(block_, capacity + alignment);
  if (block == nullptr) throw std::bad_alloc();
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  auto* base = static_cast<std::uint8_t*>(block) + (alignment - address % alignment) % alignment;
  const std::ptrdiff_t now = base - static_cast<std::uint8_t*>(block);
  if (capacity_ != 0 && now != before) std::memmove(base, static_cast<std::uint8_t*>(block) + before, capacity_);
  if (capacity_ == 0) std::memset(base, 0, alignment);  // where address 0 would be
  block_ = block;
  base_ = base;
  capacity_ = capacity;
}

Address MemoryImage::allocate(std::uint64_t bytes) {
  const Address address = top_;
  const std::uint64_t rounded = (bytes + 63) / 64 * 64;
  if (top_ + rounded > capacity_) grow(top_ + rounded);
  top_ += rounded;
  std::memset(base() + address, 0, rounded);
  return address;
}

}  // namespace artu::hw
