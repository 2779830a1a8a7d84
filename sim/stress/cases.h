// The table of stress cases: every mesh in every placement, by name ("sphere/moved-1e5").
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/stress/geometry.h"

namespace artu::sim {

struct Placement {
  const char* name;
  float scale, offset;  // position * scale + (offset, offset, offset)
};

struct StressCase {
  std::string mesh;
  Placement placement;
  std::string name() const { return mesh + "/" + placement.name; }
};

/// What a name stands for, and the placements, in the order of the report.
struct MeshEntry {
  const char* name;
  const char* what;
};
const std::vector<MeshEntry>& mesh_entries();
const std::vector<Placement>& placements();

/// All cases, or those that `only` names: a case, or a mesh in all its placements; with `closed` those of closed meshes
/// alone.  Throws InputError.
std::vector<StressCase> stress_cases(const std::string& only, bool closed = false);
bool is_closed_mesh(const std::string& mesh);

/// Whether what the mesh is made from is there.
bool is_available(const std::string& mesh);

/// `full`: at the size that its name promises, where the default is less.
StressGeometry make_mesh(const std::string& mesh, std::uint64_t seed, bool full);
StressGeometry placed(StressGeometry geometry, const Placement& placement);

}  // namespace artu::sim
