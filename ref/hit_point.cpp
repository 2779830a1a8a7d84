#include "ref/hit_point.h"

#include <cmath>

namespace artu::ref {
namespace {

struct Weights {
  float u, v, w;

  float mix(float a, float b, float c) const { return (u * a + v * b) + w * c; }
  Vec2 mix(const Vec2& a, const Vec2& b, const Vec2& c) const { return {mix(a.x, b.x, c.x), mix(a.y, b.y, c.y)}; }
  Vec3 mix(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return {mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
  }
};

Vec3 scaled(const Vec3& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

// The cross product of the edges, scaled first to a magnitude near 1 so that it neither over- nor underflows.
Vec3 geometric_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const float m = max(largest_magnitude(ab), largest_magnitude(ac));
  const int k = m == 0 ? 0 : std::ilogb(m);
  const Vec3 e1 = scaled(ab, -k), e2 = scaled(ac, -k);
  return unit({e1.y * e2.z - e1.z * e2.y, e1.z * e2.x - e1.x * e2.z, e1.x * e2.y - e1.y * e2.x});
}

Vec3 unpack(std::uint32_t color) {
  return {static_cast<float>(color & 255) / 255.0f, static_cast<float>(color >> 8 & 255) / 255.0f,
          static_cast<float>(color >> 16 & 255) / 255.0f};
}

}  // namespace

HitPoint hit_point(const traces::Mesh& mesh, std::size_t triangle, const Vec3& direction, const TriangleHit& hit,
                   int triangle_bits) {
  const std::uint32_t ia = mesh.indices[3 * triangle], ib = mesh.indices[3 * triangle + 1],
                      ic = mesh.indices[3 * triangle + 2];
  const Vec3 &a = mesh.positions[ia], &b = mesh.positions[ib], &c = mesh.positions[ic];
  Weights weights;
  weights.u = hit.u / hit.det;
  weights.v = hit.v / hit.det;
  weights.w = (1.0f - weights.u) - weights.v;

  HitPoint point;
  const Vec3 position = weights.mix(a, b, c);
  point.ng = geometric_normal(a, b, c);
  if (is_zero(point.ng)) point.ng = -direction;
  point.ns = unit(weights.mix(mesh.normals[ia], mesh.normals[ib], mesh.normals[ic]));
  if (is_zero(point.ns)) point.ns = point.ng;
  point.front = dot(point.ng, direction) <= 0;
  if (!point.front) point.ng = -point.ng;
  if (dot(point.ns, point.ng) < 0) point.ns = -point.ns;
  point.uv = weights.mix(mesh.uvs[ia], mesh.uvs[ib], mesh.uvs[ic]);
  point.color = weights.mix(unpack(mesh.colors[ia]), unpack(mesh.colors[ib]), unpack(mesh.colors[ic]));

  const float m = max(max(largest_magnitude(a), largest_magnitude(b)), largest_magnitude(c));
  const float edge = max(max(largest_magnitude(b - a), largest_magnitude(c - a)), largest_magnitude(c - b));
  const float eps = m * 0x1p-19f + edge * (16.0f / static_cast<float>(1 << triangle_bits));
  point.outside = position + point.ng * eps;
  point.inside = position - point.ng * eps;
  return point;
}

}  // namespace artu::ref
