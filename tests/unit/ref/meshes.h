// Geometry and rays for the tests of ref/.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "ref/hit_tests.h"
#include "traces/frame.h"

namespace artu::ref::testing {

using traces::Mesh;

inline std::uint32_t add_vertex(Mesh& mesh, const Vec3& position) {
  mesh.positions.push_back(position);
  mesh.normals.push_back({0, 0, 0});
  mesh.uvs.push_back({0, 0});
  mesh.colors.push_back(0xffffffffu);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

inline void add_triangle(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t material = 0) {
  for (const Vec3& p : {a, b, c}) mesh.indices.push_back(add_vertex(mesh, p));
  mesh.materials.push_back(material);
}

/// A square of half width `half` at height y; its normal is +y.
inline void add_floor(Mesh& mesh, float y, float half, std::uint32_t material = 0) {
  add_triangle(mesh, {-half, y, -half}, {-half, y, half}, {half, y, half}, material);
  add_triangle(mesh, {-half, y, -half}, {half, y, half}, {half, y, -half}, material);
}

/// Closed sphere of 20 * 4^levels triangles with shared vertices, normals outwards; `smooth` fills in normals.
inline Mesh icosphere(int levels, float radius, const Vec3& center, bool smooth = false) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<std::array<double, 3>> v = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                          {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::uint32_t> f = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                  4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                  6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto key = a < b ? std::make_pair(a, b) : std::make_pair(b, a);
      const auto found = middles.find(key);
      if (found != middles.end()) return found->second;
      v.push_back({(v[a][0] + v[b][0]) / 2, (v[a][1] + v[b][1]) / 2, (v[a][2] + v[b][2]) / 2});
      return middles[key] = static_cast<std::uint32_t>(v.size() - 1);
    };
    std::vector<std::uint32_t> next;
    for (std::size_t i = 0; i < f.size(); i += 3) {
      const std::uint32_t a = f[i], b = f[i + 1], c = f[i + 2], ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const std::uint32_t index : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) next.push_back(index);
    }
    f = next;
  }
  Mesh mesh;
  for (const auto& p : v) {
    const double s = radius / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    const Vec3 offset{static_cast<float>(p[0] * s), static_cast<float>(p[1] * s), static_cast<float>(p[2] * s)};
    const std::uint32_t index = add_vertex(mesh, center + offset);
    if (smooth) mesh.normals[index] = offset;
  }
  mesh.indices = f;
  mesh.materials.assign(f.size() / 3, 0);
  return mesh;
}

struct Random {
  std::mt19937 engine;
  explicit Random(unsigned seed) : engine(seed) {}
  float uniform(float lo, float hi) { return lo + (hi - lo) * (static_cast<float>(engine() >> 8) * 0x1p-24f); }
  Vec3 point(float half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
  std::size_t below(std::size_t n) { return engine() % n; }
};

/// Every triangle in turn, with no tree.
inline Hit brute_force(const std::vector<Triangle>& triangles, const Ray& ray, const HitTests& tests = HitTests()) {
  Hit best;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    TriangleHit hit;
    if (tests.intersect(ray, triangles[i], hit)) improve(best, static_cast<std::int64_t>(i), hit);
  }
  return best;
}

inline Vec3 vertex(const Triangle& t, int corner) {
  return {t.v[3 * corner], t.v[3 * corner + 1], t.v[3 * corner + 2]};
}

}  // namespace artu::ref::testing
