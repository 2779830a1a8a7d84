#include <cmath>

#include "sim/import/obj_file.h"

namespace artu::sim {
namespace {

constexpr double cos_crease = 0.5;  // 60 degrees
// Faces around one vertex beyond which all are averaged: the comparison below is quadratic in it.
constexpr std::size_t max_fan = 256;

}  // namespace

std::vector<glm::vec3> crease_normals(const std::vector<glm::vec3>& positions,
                                      const std::vector<std::uint32_t>& indices) {
  const std::size_t faces = indices.size() / 3;
  std::vector<glm::dvec3> area(faces), unit(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    const glm::dvec3 a = positions[indices[3 * f]], b = positions[indices[3 * f + 1]],
                     c = positions[indices[3 * f + 2]];
    area[f] = glm::cross(b - a, c - a);
    const double length = glm::length(area[f]);
    unit[f] = length > 0 ? area[f] / length : glm::dvec3(0.0);
  }
  // Faces by vertex, as one array with the start of each vertex's part.
  std::vector<std::size_t> start(positions.size() + 1);
  for (const std::uint32_t i : indices) ++start[i + 1];
  for (std::size_t v = 0; v < positions.size(); ++v) start[v + 1] += start[v];
  std::vector<std::size_t> around(indices.size()), next(start.begin(), start.end() - 1);
  for (std::size_t k = 0; k < indices.size(); ++k) around[next[indices[k]]++] = k / 3;

  // A large fan's average is the same for all of its corners, and summed once.
  std::vector<glm::dvec3> average(positions.size());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (start[indices[k] + 1] - start[indices[k]] > max_fan) average[indices[k]] += area[k / 3];
  }
  std::vector<glm::vec3> out(indices.size());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const std::uint32_t v = indices[k];
    const glm::dvec3& own = unit[k / 3];
    glm::dvec3 sum = average[v];
    if (start[v + 1] - start[v] <= max_fan) {
      for (std::size_t i = start[v]; i < start[v + 1]; ++i) {
        if (glm::dot(own, unit[around[i]]) >= cos_crease) sum += area[around[i]];
      }
    }
    const double length = glm::length(sum);
    out[k] = length > 0 ? glm::vec3(sum / length) : glm::vec3(0.0f);
  }
  return out;
}

}  // namespace artu::sim
