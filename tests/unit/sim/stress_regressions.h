// Rays that were wrong once, or nearly: each by its bits, so that it stays what it was.
#pragma once

#include <cstdint>
#include <vector>

namespace artu::sim::testing {

struct Regression {
  const char* name;
  std::vector<std::uint32_t> vertices;  // nine a triangle; every third triangle is dynamic
  std::uint32_t origin[3], direction[3], tmax;
  bool hit = true;
};

inline const std::vector<Regression>& regressions() {
  static const std::vector<Regression> all = {
      // A hit behind the origin by less than nothing: t = -0 is a hit.
      {"origin in the plane",
       {0xbf800000, 0xbf800000, 0, 0x3f800000, 0xbf800000, 0, 0, 0x3f800000, 0},
       {0, 0, 0},
       {0, 0, 0xbf800000},
       0x3f800000},
      // 0 * inv is 0, which once made a box half open to rays in its faces: of direction -0 in the low one ...
      {"in the plane of a face",
       {0, 0, 0x3f800000, 0x3f800000, 0, 0x3f800000, 0, 0x3f800000, 0x3f800000, 0, 0, 0x3f800000, 0, 0, 0x40000000, 0,
        0x3f800000, 0x3f800000},
       {0, 0x3e800000, 0},
       {0x80000000, 0, 0x3f800000},
       0x71800000},
      // ... and of direction +0.
      {"in the plane of a face, the other zero",
       {0, 0, 0x3f800000, 0x3f800000, 0, 0x3f800000, 0, 0x3f800000, 0x3f800000, 0, 0, 0x3f800000, 0, 0, 0x40000000, 0,
        0x3f800000, 0x3f800000},
       {0, 0x3e800000, 0},
       {0, 0, 0x3f800000},
       0x71800000},
      // A subnormal component: its inverse is limited to 2^100.
      {"subnormal component",
       {0xbf800000, 0xbf800000, 0x3f800000, 0x3f800000, 0xbf800000, 0x3f800000, 0, 0x3f800000, 0x3f800000},
       {0, 0, 0},
       {0x00000001, 0x80000001, 0x3f800000},
       0x71800000},
      // The same triangle in both classes: the static one has the smaller id.
      {"a tie between the classes",
       {0xbf800000, 0xbf800000, 0x3f800000, 0x3f800000, 0xbf800000, 0x3f800000, 0, 0x3f800000, 0x3f800000,
        0xbf800000, 0xbf800000, 0x3f800000, 0x3f800000, 0xbf800000, 0x3f800000, 0, 0x3f800000, 0x3f800000,
        0xbf800000, 0xbf800000, 0x3f800000, 0x3f800000, 0xbf800000, 0x3f800000, 0, 0x3f800000, 0x3f800000},
       {0, 0, 0},
       {0, 0, 0x3f800000},
       0x71800000},
      // In a face of the triangle's box the clamp's enter was 0 * inv = 0: a hit at t = 0, where exactly it is -3.5.
      {"behind the origin, in a face of its box",
       {0, 0, 0xc0a00000, 0, 0x3f800000, 0x3f800000, 0x3f800000, 0, 0xc0a00000},
       {0, 0x3e800000, 0},
       {0, 0, 0x3f800000},
       0x71800000,
       false},
      // With the other zero it was exit that was 0: a hit at t = -0, where exactly it is 0.5.
      {"before the origin, in a face of its box",
       {0, 0, 0xc0a00000, 0, 0x3f800000, 0x3f800000, 0x3f800000, 0, 0xc0a00000},
       {0, 0x3e800000, 0xc0800000},
       {0x80000000, 0, 0x3f800000},
       0x71800000},
      // Legal coordinates (below 2^62) that Embree takes in no ray (from 1.844e18 on): the golden model goes round it.
      {"origin at 2^61",
       {0xbf800000, 0xbf800000, 0x3f800000, 0x3f800000, 0xbf800000, 0x3f800000, 0, 0x3f800000, 0x3f800000},
       {0, 0, 0xde000000},
       {0, 0, 0x3f800000},
       0x71800000},
  };
  return all;
}

}  // namespace artu::sim::testing
