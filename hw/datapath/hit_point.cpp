#include "hw/datapath/hit_point.h"

namespace artu::hw {

namespace {

struct Mixer {
  float u, v, w;
  float operator()(float a, float b, float c) const { return (u * a + v * b) + w * c; }
  Vector operator()(Vector a, Vector b, Vector c) const { return (a * u + b * v) + c * w; }
};

/// Edges are scaled by a power of two first, so that small triangles keep their normal.
Vector geometric_normal(Vector a, Vector b, Vector c) {
  const Vector ab = b - a, ac = c - a;
  const float size = maximum(largest_magnitude(ab), largest_magnitude(ac));
  const int k = size > 0 ? std::ilogb(size) : 0;
  const Vector e1{std::ldexp(ab.x, -k), std::ldexp(ab.y, -k), std::ldexp(ab.z, -k)};
  const Vector e2{std::ldexp(ac.x, -k), std::ldexp(ac.y, -k), std::ldexp(ac.z, -k)};
  return unit(Vector{e1.y * e2.z - e1.z * e2.y, e1.z * e2.x - e1.x * e2.z, e1.x * e2.y - e1.y * e2.x});
}

Vector vertex_color(std::uint32_t codes) {
  return {static_cast<float>(codes & 255) / 255.0f, static_cast<float>((codes >> 8) & 255) / 255.0f,
          static_cast<float>((codes >> 16) & 255) / 255.0f};
}

}  // namespace

Surface surface_at(const Ray& ray, const TriangleHit& hit, const TriangleRecord& triangle,
                   const AttributeRecord& attributes, int triangle_bits) {
  const Vector a = triangle.a, b = triangle.b, c = triangle.c;
  Mixer mix{};
  mix.u = hit.U / hit.det;
  mix.v = hit.V / hit.det;
  mix.w = (1.0f - mix.u) - mix.v;

  Surface s;
  const Vector point = mix(a, b, c);
  Vector ng = geometric_normal(a, b, c);
  if (is_zero(ng)) ng = -ray.direction;
  Vector ns = unit(mix(attributes.normal[0], attributes.normal[1], attributes.normal[2]));
  if (is_zero(ns)) ns = ng;
  s.front = dot(ng, ray.direction) <= 0;
  if (!s.front) ng = -ng;
  if (dot(ns, ng) < 0) ns = -ns;
  s.geometric_normal = ng;
  s.shading_normal = ns;
  s.u = mix(attributes.uv[0][0], attributes.uv[1][0], attributes.uv[2][0]);
  s.v = mix(attributes.uv[0][1], attributes.uv[1][1], attributes.uv[2][1]);
  s.color = mix(vertex_color(triangle.color[0]), vertex_color(triangle.color[1]), vertex_color(triangle.color[2]));
  const float m = maximum(maximum(largest_magnitude(a), largest_magnitude(b)), largest_magnitude(c));
  const float l = maximum(maximum(largest_magnitude(b - a), largest_magnitude(c - a)), largest_magnitude(c - b));
  const float epsilon = m * 0x1p-19f + l * std::ldexp(1.0f, 4 - triangle_bits);
  s.outside = point + ng * epsilon;
  s.inside = point - ng * epsilon;
  return s;
}

}  // namespace artu::hw
