#include "sim/sampled/frame_order.h"

namespace artu::sim {

namespace {

/// Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators (2014).
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

/// In 0 ... 2^32 - 1: the digits of `number` from the lowest on, each flipped or not as those before it say.
std::uint64_t scrambled(std::uint32_t number, std::uint64_t seed) {
  std::uint64_t place = 0, before = 1;
  for (int digit = 0; digit < 32; ++digit, number >>= 1) {
    const std::uint64_t own = number & 1;
    place = place << 1 | (own ^ (mixed(seed ^ mixed(before)) & 1));
    before = before << 1 | own;
  }
  return place;
}

}  // namespace

std::vector<std::uint32_t> frame_order(std::uint32_t count, std::uint64_t seed) {
  std::vector<std::uint32_t> order;
  std::vector<bool> drawn(count, false);
  const std::uint64_t scramble = mixed(seed);
  for (std::uint32_t i = 0; order.size() < count && i < 64 * count; ++i) {
    const auto frame = static_cast<std::uint32_t>(scrambled(i, scramble) * count >> 32);
    if (drawn[frame]) continue;
    drawn[frame] = true;
    order.push_back(frame);
  }
  for (std::uint32_t frame = 0; frame < count; ++frame) {
    if (!drawn[frame]) order.push_back(frame);
  }
  return order;
}

}  // namespace artu::sim
