#include "ref/hit_point.h"

#include <cmath>
#include <limits>

namespace artu::ref {
namespace {

template <class F>
struct Weights {
  F u, v, w;

  F mix(F a, F b, F c) const { return (u * a + v * b) + w * c; }
  Uv<F> mix(const Vec2& a, const Vec2& b, const Vec2& c) const { return {mix(a.x, b.x, c.x), mix(a.y, b.y, c.y)}; }
  Vector<F> mix(const Vector<F>& a, const Vector<F>& b, const Vector<F>& c) const {
    return {mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
  }
};

template <class V>
V scaled(const V& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

// The cross product of the edges, scaled first to a magnitude near 1 so that it neither over- nor underflows.
template <class V>
V geometric_normal(const V& a, const V& b, const V& c) {
  const V ab = b - a, ac = c - a;
  const auto m = max(largest_magnitude(ab), largest_magnitude(ac));
  const int k = m == 0 ? 0 : std::ilogb(m);
  const V e1 = scaled(ab, -k), e2 = scaled(ac, -k);
  return unit(V{e1.y * e2.z - e1.z * e2.y, e1.z * e2.x - e1.x * e2.z, e1.x * e2.y - e1.y * e2.x});
}

template <class F>
Vector<F> unpack(std::uint32_t color) {
  return {static_cast<F>(color & 255) / F(255), static_cast<F>(color >> 8 & 255) / F(255),
          static_cast<F>(color >> 16 & 255) / F(255)};
}

}  // namespace

template <class F>
HitPointIn<F> hit_point(const traces::Mesh& mesh, std::size_t triangle, const Vector<F>& direction,
                        const TriangleHitIn<F>& hit, int triangle_bits) {
  const std::uint32_t ia = mesh.indices[3 * triangle], ib = mesh.indices[3 * triangle + 1],
                      ic = mesh.indices[3 * triangle + 2];
  const Vector<F> a = mesh.positions[ia], b = mesh.positions[ib], c = mesh.positions[ic];
  Weights<F> weights;
  weights.u = hit.u / hit.det;
  weights.v = hit.v / hit.det;
  weights.w = (F(1) - weights.u) - weights.v;

  HitPointIn<F> point;
  const Vector<F> position = weights.mix(a, b, c);
  point.ng = geometric_normal(a, b, c);
  if (is_zero(point.ng)) point.ng = -direction;
  point.ns = unit(weights.mix(mesh.normals[ia], mesh.normals[ib], mesh.normals[ic]));
  if (is_zero(point.ns)) point.ns = point.ng;
  point.front = dot(point.ng, direction) <= 0;
  if (!point.front) point.ng = -point.ng;
  if (dot(point.ns, point.ng) < 0) point.ns = -point.ns;
  point.uv = weights.mix(mesh.uvs[ia], mesh.uvs[ib], mesh.uvs[ic]);
  point.color = weights.mix(unpack<F>(mesh.colors[ia]), unpack<F>(mesh.colors[ib]), unpack<F>(mesh.colors[ic]));

  // Section 11 with the rounding e' of F: 2^-19 is 2^5 e' in binary32.
  constexpr F rounding = 16 * std::numeric_limits<F>::epsilon();
  const F m = max(max(largest_magnitude(a), largest_magnitude(b)), largest_magnitude(c));
  const F edge = max(max(largest_magnitude(b - a), largest_magnitude(c - a)), largest_magnitude(c - b));
  const F eps = m * rounding + edge * (F(16) / static_cast<F>(std::uint64_t{1} << triangle_bits));
  point.outside = position + point.ng * eps;
  point.inside = position - point.ng * eps;
  return point;
}

template HitPointIn<float> hit_point<float>(const traces::Mesh&, std::size_t, const Vector<float>&,
                                            const TriangleHitIn<float>&, int);
template HitPointIn<double> hit_point<double>(const traces::Mesh&, std::size_t, const Vector<double>&,
                                              const TriangleHitIn<double>&, int);

}  // namespace artu::ref
