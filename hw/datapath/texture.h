// Bilinear texture filter in linear light (docs/arithmetic.md section 6): addresses in binary32, colours in the shading
// datapath's format.
#pragma once

#include <array>

#include "hw/memory/layout.h"

namespace artu::hw {

/// Which texels a sample needs, and how it weighs them.
struct TextureFootprint {
  std::uint32_t x[2], y[2];
  float a_u, a_v;
};

TextureFootprint footprint(const MaterialRecord& material, float u, float v);

/// In the number type R.  Texels as packed R, G, B, A codes: (x0,y0), (x1,y0), (x0,y1), (x1,y1).
template <class R = float>
Vector filter(const TextureFootprint& footprint, const std::array<std::uint32_t, 4>& texels);

}  // namespace artu::hw
