// Who listens to a functional rendering: told of every line that the unit would ask its memory for, in the order of one
// pixel after another.  A listener is a template argument, so that nobody listening costs nothing.
#pragma once

#include "hw/datapath/pixel_rays.h"

namespace artu::hw {

/// Nobody.
struct NoTap {
  void pixel(std::uint32_t x, std::uint32_t y, std::uint32_t pass) {}  // is traced from now on
  void interpolated(std::uint32_t x, std::uint32_t y, std::uint32_t pass) {}
  void ray(RayKind kind) {}
  void node(Address record, TreeKind kind) {}
  void triangle(Address record) {}
  void attributes(Address record) {}
  void material(Address record) {}
  void texel(Address texel) {}
};

}  // namespace artu::hw
