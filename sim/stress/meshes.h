// The meshes of the stress campaign, made of nothing but a seed.
#pragma once

#include <string>

#include "sim/stress/geometry.h"

namespace artu::sim {

StressGeometry sphere_mesh(int levels);  // 20 * 4^levels triangles, shared vertices
/// A sphere whose edges are split at a millionth of their length: half of its triangles are slivers.
StressGeometry needle_mesh(int levels);
StressGeometry box_mesh(int steps);  // a closed box in the axes' planes, its triangles in turn of either class
StressGeometry height_mesh(int steps, std::uint64_t seed);
StressGeometry soup_mesh(int count, std::uint64_t seed);      // a third of it dynamic
StressGeometry sliver_mesh(int count, std::uint64_t seed);    // aspect 1e6
StressGeometry coplanar_mesh(int count, std::uint64_t seed);  // pairs a few units in the last place apart
StressGeometry coincident_mesh(int count,
                               std::uint64_t seed);            // the same triangle again, in any order, of either class
StressGeometry zero_area_mesh(int count, std::uint64_t seed);  // points and segments among triangles
StressGeometry identical_mesh(int count);
/// An OBJ file through the importer.
StressGeometry imported_mesh(const std::string& path);

}  // namespace artu::sim
