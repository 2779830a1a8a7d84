// Numbers that are the same on every machine: the standard's distributions are not, so everything is made from the
// bits of SplitMix64 by arithmetic that is written out.
#pragma once

#include <cstdint>
#include <string_view>

#include "hw/datapath/vector.h"

namespace artu::sim {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// A stream of its own for `index`, so that a ray does not depend on those before it.
  Random(std::uint64_t seed, std::uint64_t index) : state_(mix(seed) ^ mix(index + 0x632be59bd9b4e019u)) {}

  std::uint64_t next() { return mix(state_ += 0x9e3779b97f4a7c15u); }
  /// 0 ... n - 1, for n below 2^32.
  std::uint32_t below(std::uint64_t n) { return static_cast<std::uint32_t>(((next() >> 32) * n) >> 32); }
  /// [0, 1) in steps of 2^-24.
  float share() { return static_cast<float>(next() >> 40) * 0x1p-24f; }
  float between(float lo, float hi) { return lo + (hi - lo) * share(); }
  float sign() { return (next() >> 63) != 0 ? -1.0f : 1.0f; }
  hw::Vector within(float half) {
    const float x = between(-half, half), y = between(-half, half), z = between(-half, half);
    return {x, y, z};
  }
  /// Uniform on the unit sphere, up to rounding.
  hw::Vector direction() {
    for (;;) {
      const hw::Vector v = within(1);
      const float l = hw::dot(v, v);
      if (l > 0.01f && l <= 1) return hw::unit(v);
    }
  }

  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }
  /// FNV-1a, to turn names into seeds.
  static std::uint64_t hash(std::string_view text) {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return h;
  }

 private:
  std::uint64_t state_;
};

}  // namespace artu::sim
