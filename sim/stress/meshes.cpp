#include "sim/stress/meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sim/import/import.h"
#include "sim/stress/random.h"

namespace artu::sim {
namespace {

using hw::Vector;

void share_faces(StressGeometry& geometry, const std::vector<Vector>& vertices,
                 const std::vector<std::uint32_t>& faces) {
  for (const Vector v : vertices) add_vertex(geometry.fixed, v);
  geometry.fixed.indices = faces;
  geometry.fixed.materials.assign(faces.size() / 3, 0);
}

struct RandomTriangle {
  Vector a, b, c;
};
RandomTriangle random_triangle(Random& random, float size) {
  const Vector a = random.within(1);
  const Vector b = a + random.within(size);
  const Vector c = a + random.within(size);
  return {a, b, c};
}

}  // namespace

StressGeometry sphere_mesh(int levels) {
  // The icosahedron, each face in four again and again; a midpoint is made once for both of its faces.
  const float g = 1.61803399f;
  std::vector<Vector> v = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                           {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vector& p : v) p = hw::unit(p);
  std::vector<std::uint32_t> f = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                  4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                  6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, fresh] = middles.emplace(std::pair<std::uint32_t, std::uint32_t>(std::minmax(a, b)),
                                               static_cast<std::uint32_t>(v.size()));
      if (fresh) v.push_back(hw::unit(v[a] + v[b]));
      return at->second;
    };
    std::vector<std::uint32_t> next;
    for (std::size_t i = 0; i < f.size(); i += 3) {
      const std::uint32_t a = f[i], b = f[i + 1], c = f[i + 2], ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const std::uint32_t index : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) next.push_back(index);
    }
    f = std::move(next);
  }
  StressGeometry geometry;
  share_faces(geometry, v, f);
  geometry.closed = geometry.convex = true;
  return geometry;
}

StressGeometry needle_mesh(int levels) {
  const StressGeometry sphere = sphere_mesh(levels);
  const traces::Mesh& mesh = sphere.fixed;
  std::vector<Vector> v;
  for (const traces::Vec3& p : mesh.positions) v.push_back({p.x, p.y, p.z});
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> splits;
  const auto split = [&](std::uint32_t a, std::uint32_t b) {
    const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(a, b);
    const auto [at, fresh] = splits.emplace(edge, static_cast<std::uint32_t>(v.size()));
    if (fresh) v.push_back(v[edge.first] + (v[edge.second] - v[edge.first]) * 1e-6f);
    return at->second;
  };
  std::vector<std::uint32_t> faces;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
    const std::uint32_t ab = split(a, b), bc = split(b, c), ca = split(c, a);
    for (const std::uint32_t index : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) faces.push_back(index);
  }
  StressGeometry geometry;
  share_faces(geometry, v, faces);
  geometry.closed = true;
  return geometry;
}

StressGeometry box_mesh(int steps) {
  StressGeometry geometry;
  int turn = 0;
  const auto coordinate = [&](int i) { return static_cast<float>(2 * i - steps) / static_cast<float>(steps); };
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto corner = [&](int i, int j) -> Vector {
        const float p = coordinate(i), q = side > 0 ? coordinate(j) : coordinate(steps - j);
        return axis == 0 ? Vector{side, p, q} : axis == 1 ? Vector{q, side, p} : Vector{p, q, side};
      };
      for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
          add_triangle(turn++ % 2 == 0 ? geometry.fixed : geometry.dynamic, corner(i, j), corner(i + 1, j),
                       corner(i + 1, j + 1));
          add_triangle(turn++ % 3 == 0 ? geometry.dynamic : geometry.fixed, corner(i, j), corner(i + 1, j + 1),
                       corner(i, j + 1));
        }
      }
    }
  }
  geometry.closed = true;
  return geometry;
}

StressGeometry height_mesh(int steps, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vector> v;
  std::vector<std::uint32_t> f;
  const float step = 2.0f / static_cast<float>(steps);
  for (int j = 0; j <= steps; ++j) {
    for (int i = 0; i <= steps; ++i) {
      v.push_back({static_cast<float>(i) * step - 1, random.between(-0.05f, 0.05f), static_cast<float>(j) * step - 1});
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (steps + 1) + i); };
  for (int j = 0; j < steps; ++j) {
    for (int i = 0; i < steps; ++i) {
      for (const std::uint32_t index :
           {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)}) {
        f.push_back(index);
      }
    }
  }
  StressGeometry geometry;
  share_faces(geometry, v, f);
  return geometry;
}

StressGeometry soup_mesh(int count, std::uint64_t seed) {
  Random random(seed);
  StressGeometry geometry;
  for (int i = 0; i < count; ++i) {
    const RandomTriangle t = random_triangle(random, i % 10 == 0 ? 1.0f : 0.2f);
    add_triangle(i % 3 == 0 ? geometry.dynamic : geometry.fixed, t.a, t.b, t.c);
  }
  return geometry;
}

StressGeometry sliver_mesh(int count, std::uint64_t seed) {
  Random random(seed);
  StressGeometry geometry;
  for (int i = 0; i < count; ++i) {
    const Vector a = random.within(1);
    const Vector b = a + random.direction();
    // The third vertex lies near the long side: at its end, or on its way.
    const Vector c = a + (b - a) * (i % 2 == 0 ? 1.0f : random.share()) + random.direction() * 1e-6f;
    add_triangle(geometry.fixed, a, b, c);
  }
  return geometry;
}

StressGeometry coplanar_mesh(int count, std::uint64_t seed) {
  Random random(seed);
  StressGeometry geometry;
  for (int i = 0; i < count; i += 2) {
    const RandomTriangle t = random_triangle(random, 0.5f);
    const Vector off = random.within(3e-7f);
    add_triangle(geometry.fixed, t.a, t.b, t.c);
    add_triangle(i % 4 == 0 ? geometry.dynamic : geometry.fixed, t.b + off, t.c + off, t.a + off);
  }
  return geometry;
}

StressGeometry coincident_mesh(int count, std::uint64_t seed) {
  Random random(seed);
  StressGeometry geometry;
  for (int i = 0; i < count; i += 4) {
    const RandomTriangle t = random_triangle(random, 0.4f);
    add_triangle(geometry.fixed, t.a, t.b, t.c);
    add_triangle(geometry.dynamic, t.a, t.b, t.c);
    add_triangle(geometry.fixed, t.b, t.c, t.a);
    add_triangle(i % 8 == 0 ? geometry.dynamic : geometry.fixed, t.a, t.c, t.b);
  }
  return geometry;
}

StressGeometry zero_area_mesh(int count, std::uint64_t seed) {
  Random random(seed);
  StressGeometry geometry;
  for (int i = 0; i < count; i += 4) {
    const RandomTriangle t = random_triangle(random, 0.4f);
    add_triangle(geometry.fixed, t.a, t.b, t.c);
    add_triangle(geometry.fixed, t.a, t.a, t.a);
    add_triangle(geometry.dynamic, t.a, t.b, t.a);
    add_triangle(geometry.dynamic, t.a, t.b, t.a * 0.5f + t.b * 0.5f);
  }
  return geometry;
}

StressGeometry identical_mesh(int count) {
  StressGeometry geometry;
  for (int i = 0; i < count; ++i) add_triangle(geometry.fixed, {-1, -0.5f, 0.25f}, {1, -0.75f, -0.25f}, {0.125f, 1, 0});
  return geometry;
}

StressGeometry imported_mesh(const std::string& path) {
  std::vector<std::string> log;
  const auto source = SceneSource::open(path, {}, log);
  StressGeometry geometry;
  geometry.fixed = source->scene().static_geometry;
  geometry.dynamic = source->frame(0).dynamic;
  geometry.closed = is_closed(geometry);
  return geometry;
}

}  // namespace artu::sim
