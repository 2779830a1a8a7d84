#include "hw/datapath/texture.h"

#include "hw/datapath/color.h"

namespace artu::hw {

namespace {

float wrapped(TextureWrap wrap, float u) {
  switch (wrap) {
    case TextureWrap::repeat:
      return u - std::floor(u);
    case TextureWrap::clamp:
      return minimum(maximum(u, 0.0f), 1.0f);
    case TextureWrap::mirror:
      break;
  }
  const float g = u - 2.0f * std::floor(u * 0.5f);
  return g > 1.0f ? 2.0f - g : g;
}

std::uint32_t wrapped(TextureWrap wrap, std::int32_t i, std::int32_t n) {
  if (wrap == TextureWrap::repeat) {
    if (i < 0) i += n;
    if (i >= n) i -= n;
  }
  return static_cast<std::uint32_t>(i < 0 ? 0 : i >= n ? n - 1 : i);
}

float along(TextureWrap wrap, float u, std::uint32_t n, std::uint32_t index[2]) {
  const float s = wrapped(wrap, u) * static_cast<float>(n) - 0.5f;
  const float floored = std::floor(s);
  const auto i = static_cast<std::int32_t>(floored);
  index[0] = wrapped(wrap, i, static_cast<std::int32_t>(n));
  index[1] = wrapped(wrap, i + 1, static_cast<std::int32_t>(n));
  return s - floored;
}

template <class R>
VectorOf<R> decode_texel(std::uint32_t texel) {
  return to<R>({decode(texel & 255), decode((texel >> 8) & 255), decode((texel >> 16) & 255)});
}

}  // namespace

TextureFootprint footprint(const MaterialRecord& material, float u, float v) {
  TextureFootprint f;
  f.a_u = along(material.wrap_u, u, material.width, f.x);
  f.a_v = along(material.wrap_v, v, material.height, f.y);
  return f;
}

template <class R>
Vector filter(const TextureFootprint& f, const std::array<std::uint32_t, 4>& texels) {
  const VectorOf<R> t00 = decode_texel<R>(texels[0]), t10 = decode_texel<R>(texels[1]);
  const VectorOf<R> t01 = decode_texel<R>(texels[2]), t11 = decode_texel<R>(texels[3]);
  const R a_u = R(f.a_u), a_v = R(f.a_v);
  const VectorOf<R> top = t00 + (t10 - t00) * a_u;
  const VectorOf<R> bottom = t01 + (t11 - t01) * a_u;
  return from(top + (bottom - top) * a_v);
}

#define ARTU_INSTANTIATE(R) template Vector filter<R>(const TextureFootprint&, const std::array<std::uint32_t, 4>&);
#include "hw/datapath/every_width.inc"

}  // namespace artu::hw
