#include "hw/memory/image.h"

#include <algorithm>

namespace artu::hw {

Address MemoryImage::allocate(std::uint64_t bytes) {
  const Address address = top_;
  const std::uint64_t rounded = (bytes + 63) / 64 * 64;
  top_ += rounded;
  const std::size_t lines = static_cast<std::size_t>(top_ / 64);
  if (lines_.size() < lines) lines_.resize(lines);
  std::memset(base() + address, 0, rounded);
  return address;
}

}  // namespace artu::hw
