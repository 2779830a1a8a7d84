#include "ref/texture.h"

#include <cmath>
#include <cstddef>

#include "ref/color.h"

namespace artu::ref {
namespace {

template <class F>
F wrapped(F u, traces::Wrap wrap) {
  if (wrap == traces::Wrap::repeat) return u - std::floor(u);
  if (wrap == traces::Wrap::clamp) return min(max(u, F(0)), F(1));
  const F g = u - F(2) * std::floor(u * F(0.5));
  return g > F(1) ? F(2) - g : g;
}

std::int32_t wrapped_index(std::int32_t i, std::int32_t size, traces::Wrap wrap) {
  if (wrap == traces::Wrap::repeat) return i < 0 ? i + size : i >= size ? i - size : i;
  return i < 0 ? 0 : i >= size ? size - 1 : i;
}

template <class F>
Vector<F> texel(const traces::Texture& texture, std::int32_t x, std::int32_t y, const SrgbIn<F>& tables) {
  const std::uint8_t* p = &texture.rgba[4 * (static_cast<std::size_t>(y) * texture.width + x)];
  return {tables.decode(p[0]), tables.decode(p[1]), tables.decode(p[2])};
}

}  // namespace

template <class F>
Tap<F> tap(F coordinate, std::uint32_t size, traces::Wrap wrap) {
  const F s = wrapped(coordinate, wrap) * static_cast<F>(size) - F(0.5);
  const F floored = std::floor(s);
  const auto i = static_cast<std::int32_t>(floored), n = static_cast<std::int32_t>(size);
  return {wrapped_index(i, n, wrap), wrapped_index(i + 1, n, wrap), s - floored};
}

template <class F>
Texels<F> fetch(const traces::Texture& texture, F u, F v) {
  const SrgbIn<F>& tables = srgb<F>();
  const Tap<F> x = tap(u, texture.width, texture.wrap_u), y = tap(v, texture.height, texture.wrap_v);
  return {texel(texture, x.first, y.first, tables),
          texel(texture, x.second, y.first, tables),
          texel(texture, x.first, y.second, tables),
          texel(texture, x.second, y.second, tables),
          x.weight,
          y.weight};
}

template Tap<float> tap(float, std::uint32_t, traces::Wrap);
template Tap<double> tap(double, std::uint32_t, traces::Wrap);
template Texels<float> fetch(const traces::Texture&, float, float);
template Texels<double> fetch(const traces::Texture&, double, double);

}  // namespace artu::ref
