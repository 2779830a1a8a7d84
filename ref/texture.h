// Bilinear texture look-up in linear light (docs/arithmetic.md section 6).
#pragma once

#include <cstdint>

#include "ref/vec.h"

namespace artu::ref {

/// Where a coordinate falls along one axis of a texture: two texels and the weight of the second.
struct Tap {
  std::int32_t first, second;  // 0 ... size - 1
  float weight;
};

Tap tap(float coordinate, std::uint32_t size, traces::Wrap wrap);

/// R, G, B in linear light, 0 ... 1.
Vec3 sample(const traces::Texture& texture, const Vec2& uv);

}  // namespace artu::ref
