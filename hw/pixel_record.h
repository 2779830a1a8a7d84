// What the unit lets an observer see of each pixel: the columns of docs/selective-rendering.md.
//
// Written by the blocks as a side effect without timing (a debug tap), read by the golden comparison.
#pragma once

#include <cstdint>
#include <vector>

namespace artu::hw {

enum class HitClass : std::uint8_t { none, miss, static_geometry, dynamic_geometry };
enum class Decision : std::uint8_t { sampled, interpolated, traced };

struct PixelRecord {
  std::uint8_t pass = 0;
  HitClass hit_class = HitClass::none;
  std::uint8_t n_static = 0, n_dynamic = 0;
  std::int16_t threshold = -1, difference = -1;  // 8-bit codes; -1 where there is none
  Decision decision = Decision::sampled;
  std::uint8_t r = 0, g = 0, b = 0;  // sRGB codes
  std::uint8_t written = 0;          // times the frame buffer pixel was written: must be 1
  std::int64_t primitive = -1;       // of the primary ray, or -1
  std::uint32_t t_bits = 0;          // bits of the primary hit's t; 0 without a hit
  std::uint32_t cycles = 0;          // from its job's dispatch to its write; 0 where no ray was traced
};

/// Row by row, width * height.
using PixelRecords = std::vector<PixelRecord>;

}  // namespace artu::hw
