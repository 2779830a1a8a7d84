#include "ref/texture.h"

#include <cmath>
#include <cstddef>

#include "ref/color.h"

namespace artu::ref {
namespace {

float wrapped(float u, traces::Wrap wrap) {
  if (wrap == traces::Wrap::repeat) return u - std::floor(u);
  if (wrap == traces::Wrap::clamp) return min(max(u, 0.0f), 1.0f);
  const float g = u - 2.0f * std::floor(u * 0.5f);
  return g > 1.0f ? 2.0f - g : g;
}

std::int32_t wrapped(std::int32_t i, std::int32_t size, traces::Wrap wrap) {
  if (wrap == traces::Wrap::repeat) return i < 0 ? i + size : i >= size ? i - size : i;
  return i < 0 ? 0 : i >= size ? size - 1 : i;
}

Vec3 texel(const traces::Texture& texture, std::int32_t x, std::int32_t y, const Srgb& tables) {
  const std::uint8_t* p = &texture.rgba[4 * (static_cast<std::size_t>(y) * texture.width + x)];
  return {tables.decode(p[0]), tables.decode(p[1]), tables.decode(p[2])};
}

}  // namespace

Tap tap(float coordinate, std::uint32_t size, traces::Wrap wrap) {
  const float s = wrapped(coordinate, wrap) * static_cast<float>(size) - 0.5f;
  const float floored = std::floor(s);
  const auto i = static_cast<std::int32_t>(floored), n = static_cast<std::int32_t>(size);
  return {wrapped(i, n, wrap), wrapped(i + 1, n, wrap), s - floored};
}

Texels fetch(const traces::Texture& texture, const Vec2& uv) {
  const Srgb& tables = srgb();
  const Tap x = tap(uv.x, texture.width, texture.wrap_u), y = tap(uv.y, texture.height, texture.wrap_v);
  return {texel(texture, x.first, y.first, tables),
          texel(texture, x.second, y.first, tables),
          texel(texture, x.first, y.second, tables),
          texel(texture, x.second, y.second, tables),
          x.weight,
          y.weight};
}

}  // namespace artu::ref
