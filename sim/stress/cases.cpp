#include "sim/stress/cases.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "sim/config/edit_distance.h"
#include "sim/stress/meshes.h"
#include "sim/stress/random.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr const char* bunny_file = "/usr/share/glmark2/models/bunny.obj";

std::string nearest_of(const std::vector<std::string>& names, const std::string& wanted) {
  return *std::min_element(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(wanted, a) < edit_distance(wanted, b);
  });
}

}  // namespace

const std::vector<MeshEntry>& mesh_entries() {
  static const std::vector<MeshEntry> entries = {
      {"sphere", "closed and convex, 20,480 triangles"},
      {"box", "closed, in the axes' planes, 3,072 triangles of both classes"},
      {"needles", "closed, 5,120 triangles, half of them slivers of aspect 1e6"},
      {"height", "height field, 8,192 triangles"},
      {"soup", "1,500 random triangles of both classes"},
      {"slivers", "1,000 triangles of aspect 1e6"},
      {"coplanar", "1,000 triangles in pairs a few units in the last place apart"},
      {"coincident", "1,200 triangles, each four times, of both classes"},
      {"zero-area", "1,200 triangles, three of four a point or a segment"},
      {"one", "one triangle"},
      {"empty", "no triangle"},
      {"identical", "one triangle 1,000,000 times; 1,000 times unless it is named with --only"},
      {"bunny", "the bunny of glmark2, closed, 69,666 triangles, if it is installed"},
  };
  return entries;
}

const std::vector<Placement>& placements() {
  static const std::vector<Placement> all = {
      {"as-is", 1, 0},           {"moved-1e3", 1, 1e3f},    {"moved-1e5", 1, 1e5f},  {"moved-1e7", 1, 1e7f},
      {"scaled-1e-6", 1e-6f, 0}, {"scaled-1e-3", 1e-3f, 0}, {"scaled-1e3", 1e3f, 0}, {"scaled-1e6", 1e6f, 0},
  };
  return all;
}

bool is_closed_mesh(const std::string& mesh) {
  return mesh == "sphere" || mesh == "box" || mesh == "needles" || mesh == "bunny";
}

std::vector<StressCase> stress_cases(const std::string& only, bool closed) {
  std::vector<StressCase> cases;
  std::vector<std::string> names;
  for (const MeshEntry& mesh : mesh_entries()) {
    if (closed && !is_closed_mesh(mesh.name)) continue;
    names.emplace_back(mesh.name);
    for (const Placement& placement : placements()) {
      const StressCase one{mesh.name, placement};
      names.push_back(one.name());
      if (only.empty() || only == mesh.name || only == names.back()) cases.push_back(one);
    }
  }
  if (cases.empty()) {
    const std::string nearest = nearest_of(names, only);
    throw InputError("--only", "unknown case \"" + only + (closed ? "\" of a closed mesh; " : "\"; ") +
                                   (resembles(only, nearest) ? "did you mean " + nearest + "?"
                                                             : "one that artu stress --list prints would be right"));
  }
  return cases;
}

bool is_available(const std::string& mesh) {
  std::error_code ignored;
  return mesh != "bunny" || std::filesystem::exists(bunny_file, ignored);
}

StressGeometry make_mesh(const std::string& mesh, std::uint64_t seed, bool full) {
  seed = Random::mix(seed) ^ Random::hash(mesh);
  if (mesh == "sphere") return sphere_mesh(5);
  if (mesh == "needles") return needle_mesh(3);
  if (mesh == "box") return box_mesh(16);
  if (mesh == "height") return height_mesh(64, seed);
  if (mesh == "soup") return soup_mesh(1500, seed);
  if (mesh == "slivers") return sliver_mesh(1000, seed);
  if (mesh == "coplanar") return coplanar_mesh(1000, seed);
  if (mesh == "coincident") return coincident_mesh(1200, seed);
  if (mesh == "zero-area") return zero_area_mesh(1200, seed);
  if (mesh == "one") return identical_mesh(1);
  if (mesh == "empty") return {};
  if (mesh == "identical") return identical_mesh(full ? 1000000 : 1000);
  if (mesh == "bunny") return imported_mesh(bunny_file);
  throw std::logic_error("stress: no mesh " + mesh);
}

StressGeometry placed(StressGeometry geometry, const Placement& placement) {
  const float offset = placement.offset;
  for (traces::Mesh* mesh : {&geometry.fixed, &geometry.dynamic}) {
    for (traces::Vec3& p : mesh->positions) {
      p = {p.x * placement.scale + offset, p.y * placement.scale + offset, p.z * placement.scale + offset};
    }
  }
  // Rounding at a far place leaves the surface closed, but not convex.
  geometry.convex = geometry.convex && offset == 0;
  return geometry;
}

}  // namespace artu::sim
