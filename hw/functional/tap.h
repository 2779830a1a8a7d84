// Who listens to a functional rendering: told of every line that the unit would ask its memory for, in the order of one
// pixel after another.  A listener is a template argument, so that nobody listening costs nothing.
#pragma once

#include "hw/functional/counts.h"

namespace artu::hw {

/// Nobody.
struct NoTap {
  void begin_pass(std::uint32_t pass, const FunctionalCounts& counts) {}  // from pass 1 on; counts of all before it
  void pixel(std::uint32_t x, std::uint32_t y, std::uint32_t pass) {}     // is traced from now on
  void interpolated(std::uint32_t x, std::uint32_t y, std::uint32_t pass) {}
  void ray(RayKind kind) {}
  void node(Address record, TreeKind kind) {}              // is visited
  void leaf(Address first, std::uint32_t count) {}         // its triangles
  void hit_point(Address triangle, Address attributes) {}  // of a hit
  void material(Address record) {}
  void texel(Address texel) {}
  void end_of_pixel() {}
};

}  // namespace artu::hw
