// Bilinear texture look-up in linear light (docs/arithmetic.md section 6).
#pragma once

#include <cstdint>

#include "ref/triple.h"

namespace artu::ref {

/// Where a coordinate falls along one axis of a texture: two texels and the weight of the second.
/// F, here and below, is that of the coordinates: float or double.
template <class F>
struct Tap {
  std::int32_t first, second;  // 0 ... size - 1
  F weight;
};

template <class F>
Tap<F> tap(F coordinate, std::uint32_t size, traces::Wrap wrap);

/// The four texels of a look-up in linear light, 0 ... 1, and the weights of the second ones.
template <class F>
struct Texels {
  Vector<F> t00, t10, t01, t11;  // t10 is right of t00, t01 below it
  F au, av;
};

template <class F>
Texels<F> fetch(const traces::Texture& texture, F u, F v);

/// R, G, B in linear light, 0 ... 1, filtered in numbers of type N.
template <class N, class Coordinates = Vec2>
Triple<N> sample(const traces::Texture& texture, const Coordinates& uv) {
  const auto lerp = [](const Triple<N>& a, const Triple<N>& b, N weight) { return a + (b - a) * weight; };
  const auto t = fetch(texture, uv.x, uv.y);
  return lerp(lerp(t.t00, t.t10, t.au), lerp(t.t01, t.t11, t.au), t.av);
}

}  // namespace artu::ref
