// Rays chosen to make a tree fail, and what must come out of it.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "ref/embree_scene.h"
#include "unit/ref/meshes.h"

namespace artu::ref::testing {

inline std::uint32_t bits(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  return b;
}

inline float power_of_two(Random& random, int lo, int hi) {
  return std::ldexp(1.0f, lo + static_cast<int>(random.below(static_cast<std::size_t>(hi - lo) + 1)));
}

/// Half of them slivers, nearly degenerate or flat boxes.
inline Triangle random_triangle(Random& random, const Vec3& near, float size) {
  Triangle t;
  Vec3 a = near + random.point(size), b = near + random.point(size), c = near + random.point(size);
  switch (random.below(6)) {
    case 0:
      b = a + (b - a) * 0x1p-12f;  // a sliver
      break;
    case 1:
      c = a + (b - a) * random.uniform(0, 1);  // nearly degenerate
      break;
    case 2:
      a.y = b.y = c.y;  // in a face of its box
      break;
    default:
      break;
  }
  t.v = {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
  return t;
}

// On a vertex, an edge or inside of a random triangle.
inline Vec3 target(const std::vector<Triangle>& triangles, Random& random) {
  const Triangle& t = triangles[random.below(triangles.size())];
  const Vec3 a = vertex(t, 0), b = vertex(t, 1), c = vertex(t, 2);
  switch (random.below(4)) {
    case 0:
      return a;
    case 1:
      return (a + b) * 0.5f;
    case 2:
      return a + (c - a) * random.uniform(0, 1);
    default:
      return a * 0.5f + (b * 0.25f + c * 0.25f);
  }
}

inline Vec3 random_direction(Random& random) {
  const float tiny[] = {0, -0.0f, 1e-20f, -1e-30f, 1e-35f, -1e-19f, 1e-6f};
  Vec3 d = random.point(1);
  switch (random.below(4)) {
    case 0:
      d = Vec3{};
      (random.below(3) == 0 ? d.x : random.below(2) == 0 ? d.y : d.z) = random.below(2) == 0 ? 1.0f : -1.0f;
      if (d.x == 0) d.x = tiny[random.below(7)];
      if (d.y == 0) d.y = tiny[random.below(7)];
      return d;
    case 1:
      d.x = tiny[random.below(7)];
      break;
    case 2:
      d.y = tiny[random.below(7)];
      break;
    default:
      break;
  }
  return unit(d);
}

// Rays of a group share the distance that the padding is computed from.
inline std::vector<Ray> adversarial_rays(const std::vector<Triangle>& triangles, const Vec3& center, float distance,
                                         int count, unsigned seed, const HitTests& tests = HitTests()) {
  Random random(seed);
  std::vector<Ray> rays;
  while (static_cast<int>(rays.size()) < count) {
    const Vec3 goal = target(triangles, random);
    Vec3 origin = center + random.point(distance);
    switch (random.below(5)) {
      case 0: {  // parallel to the axes, through the goal
        const Vec3 d = random_direction(random);
        rays.push_back(tests.ray(goal - d * random.uniform(0, distance), d));
        break;
      }
      case 1:  // from the surface itself
        rays.push_back(tests.ray(goal, random_direction(random)));
        break;
      case 2:  // a shadow ray, not unit length, that ends on the surface
        if (!is_dead(goal - origin)) rays.push_back(tests.ray(origin, goal - origin, 1.0f));
        break;
      case 3:  // along a line of vertices
        origin = target(triangles, random);
        if (!is_dead(unit(goal - origin))) rays.push_back(tests.ray(origin, unit(goal - origin)));
        break;
      default:
        if (!is_dead(unit(goal - origin))) rays.push_back(tests.ray(origin, unit(goal - origin)));
    }
  }
  return rays;
}

inline double padding_of(const EmbreeScene& scene, const std::vector<Ray>& rays) {
  Extent origins;
  for (const Ray& ray : rays) origins.add({ray.origin.x, ray.origin.y, ray.origin.z});
  return required_padding(scene.extent(), origins, scene.tests().precision());
}

/// Embree's closest hits of the mesh, and whether there are any, against a loop over all triangles.
inline void expect_equal(const Mesh& mesh, const Vec3& center, float distance, int count, unsigned seed,
                         const HitTests& tests = HitTests()) {
  const EmbreeDevice device;
  EmbreeScene scene(device, tests);
  scene.set(mesh, 0);
  const std::vector<Ray> rays = adversarial_rays(scene.triangles(), center, distance, count, seed, tests);
  scene.build(padding_of(scene, rays));
  int hits = 0;
  for (const Ray& ray : rays) {
    const Hit expected = brute_force(scene.triangles(), ray, tests);
    Hit found;
    scene.closest(ray, found);
    SCOPED_TRACE("origin " + std::to_string(ray.origin.x) + " direction " + std::to_string(ray.direction.x) + " " +
                 std::to_string(ray.direction.y) + " " + std::to_string(ray.direction.z));
    ASSERT_EQ(found.id, expected.id) << found.at.t << " " << expected.at.t << " tmax " << ray.tmax;
    ASSERT_EQ(bits(found.at.t), bits(expected.at.t));
    ASSERT_EQ(bits(found.at.u), bits(expected.at.u));
    ASSERT_EQ(scene.occluded(ray), expected.id >= 0);
    hits += expected.id >= 0;
  }
  EXPECT_GT(hits, count / 4);  // the rays do test something
}

/// Triangles with ties, slivers and flat boxes.
inline Mesh soup(unsigned seed, float scale) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < 700; ++i) {
    const Vec3 a = random.point(scale), b = a + random.point(0.2f * scale), c = a + random.point(0.2f * scale);
    add_triangle(mesh, a, b, c);
    if (i % 3 == 0) add_triangle(mesh, b, c, a);                              // coincident: a tie, or nearly
    if (i % 3 == 1) add_triangle(mesh, a, b, c);                              // the very same: always a tie
    if (i % 5 == 0) add_triangle(mesh, a, b, a + (b - a) * 0.5f);             // degenerate or a sliver
    if (i % 7 == 0) add_triangle(mesh, a, {b.x, a.y, b.z}, {c.x, a.y, c.z});  // flat box
  }
  return mesh;
}

inline Mesh moved(Mesh mesh, const Vec3& offset) {
  for (Vec3& p : mesh.positions) p = p + offset;
  return mesh;
}

/// No ray may leave a closed mesh, however it is aimed at the edges and vertices that triangles share.
inline void expect_watertight(const Vec3& center, int levels, const HitTests& tests = HitTests()) {
  const EmbreeDevice device;
  EmbreeScene scene(device, tests);
  scene.set(icosphere(levels, 1, center), 0);
  Random random(21);
  std::vector<Ray> rays;
  for (const Triangle& t : scene.triangles()) {
    const Vec3 origin = center + random.point(0.5f);
    const Vec3 a = vertex(t, 0), b = vertex(t, 1);
    for (const Vec3& goal : {a, (a + b) * 0.5f, a + (b - a) * random.uniform(0, 1)}) {
      rays.push_back(tests.ray(origin, unit(goal - origin)));
    }
    // Parallel to an axis and exactly through a vertex or an edge.
    rays.push_back(tests.ray({a.x, a.y, center.z}, {0, 0, a.z < center.z ? -1.0f : 1.0f}));
    rays.push_back(tests.ray({a.x, center.y, a.z}, {-0.0f, a.y < center.y ? -1.0f : 1.0f, -0.0f}));
  }
  scene.build(padding_of(scene, rays));
  for (const Ray& ray : rays) {
    // Rays on the silhouette graze the sphere and may miss; all others begin inside.
    const Vec3 r = ray.origin - center;
    if (dot(r, r) > 0.98f) continue;
    Hit hit;
    scene.closest(ray, hit);
    ASSERT_GE(hit.id, 0);
    ASSERT_TRUE(scene.occluded(ray));
  }
}

}  // namespace artu::ref::testing
