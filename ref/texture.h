// Bilinear texture look-up in linear light (docs/arithmetic.md section 6).
#pragma once

#include <cstdint>

#include "ref/triple.h"

namespace artu::ref {

/// Where a coordinate falls along one axis of a texture: two texels and the weight of the second.
struct Tap {
  std::int32_t first, second;  // 0 ... size - 1
  float weight;
};

Tap tap(float coordinate, std::uint32_t size, traces::Wrap wrap);

/// The four texels of a look-up in linear light, 0 ... 1, and the weights of the second ones.
struct Texels {
  Vec3 t00, t10, t01, t11;  // t10 is right of t00, t01 below it
  float au, av;
};

Texels fetch(const traces::Texture& texture, const Vec2& uv);

/// R, G, B in linear light, 0 ... 1, filtered in numbers of type N.
template <class N>
Triple<N> sample(const traces::Texture& texture, const Vec2& uv) {
  const auto lerp = [](const Triple<N>& a, const Triple<N>& b, N weight) { return a + (b - a) * weight; };
  const Texels t = fetch(texture, uv);
  return lerp(lerp(t.t00, t.t10, t.au), lerp(t.t01, t.t11, t.au), t.av);
}

}  // namespace artu::ref
