#include "sim/import/emit.h"

#include <cmath>

#include "traces/error.h"
#include "traces/validate.h"

namespace artu::sim {
namespace {

/// What takes normals along with a linear map: the inverse transpose up to a positive factor, without a division,
/// so that a flattened (singular) node still has normals.
glm::dmat3 normal_matrix(const glm::dmat3& m) {
  const glm::dmat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0 ? -cofactor : cofactor;
}

traces::Vec3 unit_or_zero(const glm::dvec3& n) {
  const double length = glm::length(n);
  if (!(length > 1e-100) || !std::isfinite(length)) return {};
  return {static_cast<float>(n.x / length), static_cast<float>(n.y / length), static_cast<float>(n.z / length)};
}

/// Position and normal of a vertex with its morph targets, before any transform.
struct Morphed {
  const Geometry& geometry;
  const std::vector<double>& weights;

  glm::dvec3 position(std::size_t v) const {
    glm::dvec3 p = geometry.positions[v];
    for (std::size_t t = 0; t < geometry.targets.size() && t < weights.size(); ++t) {
      if (weights[t] != 0 && !geometry.targets[t].positions.empty())
        p += weights[t] * glm::dvec3(geometry.targets[t].positions[v]);
    }
    return p;
  }
  glm::dvec3 normal(std::size_t v) const {
    if (geometry.normals.empty()) return glm::dvec3(0.0);
    glm::dvec3 n = geometry.normals[v];
    for (std::size_t t = 0; t < geometry.targets.size() && t < weights.size(); ++t) {
      if (weights[t] != 0 && !geometry.targets[t].normals.empty())
        n += weights[t] * glm::dvec3(geometry.targets[t].normals[v]);
    }
    return n;
  }
};

class Emitter {
 public:
  Emitter(const std::string& where, traces::Mesh& out) : where_(where), out_(out) {}

  void vertex(const glm::dvec3& p, const glm::dvec3& n) {
    const double limit = traces::coordinate_limit;
    if (!(std::abs(p.x) < limit && std::abs(p.y) < limit && std::abs(p.z) < limit))
      throw InputError(where_,
                       "a vertex is not finite or too far away once it is in world space; check the "
                       "transforms of the node and its parents");
    out_.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    out_.normals.push_back(unit_or_zero(n));
  }

  void rest(const Primitive& primitive, bool mirrored, std::uint32_t base) {
    const Geometry& g = *primitive.geometry;
    const std::size_t count = g.positions.size();
    if (g.uvs.empty()) out_.uvs.resize(out_.uvs.size() + count);
    for (const glm::vec2& uv : g.uvs) out_.uvs.push_back({uv.x, uv.y});
    if (g.colors.empty()) out_.colors.resize(out_.colors.size() + count, 0xffffffffu);
    out_.colors.insert(out_.colors.end(), g.colors.begin(), g.colors.end());
    for (std::size_t i = 0; i + 2 < g.indices.size(); i += 3) {
      // A mirrored triangle turns its back: swap two corners, so that the unit still knows inside from outside.
      out_.indices.push_back(base + g.indices[i]);
      out_.indices.push_back(base + g.indices[mirrored ? i + 2 : i + 1]);
      out_.indices.push_back(base + g.indices[mirrored ? i + 1 : i + 2]);
    }
    out_.materials.insert(out_.materials.end(), g.triangle_count(), primitive.material);
  }

 private:
  const std::string& where_;
  traces::Mesh& out_;
};

bool emit_rigid(const Morphed& source, const glm::dmat4& world, Emitter& emitter) {
  const glm::dmat3 linear(world);
  const glm::dmat3 normals = normal_matrix(linear);
  const glm::dvec3 origin(world[3]);
  for (std::size_t v = 0; v < source.geometry.positions.size(); ++v)
    emitter.vertex(linear * source.position(v) + origin, normals * source.normal(v));
  return glm::determinant(linear) < 0;
}

bool emit_skinned(const Morphed& source, const std::vector<glm::dmat4>& joints, Emitter& emitter) {
  const Geometry& g = source.geometry;
  bool mirrored = false;
  for (std::size_t v = 0; v < g.positions.size(); ++v) {
    glm::dmat4 m(0.0);
    for (std::size_t k = v * g.influences; k < (v + 1) * g.influences; ++k) {
      if (g.weights[k] != 0) m += static_cast<double>(g.weights[k]) * joints[g.joints[k]];
    }
    const glm::dmat3 linear(m);
    if (v == 0) mirrored = glm::determinant(linear) < 0;
    emitter.vertex(linear * source.position(v) + glm::dvec3(m[3]), normal_matrix(linear) * source.normal(v));
  }
  return mirrored;
}

}  // namespace

void emit_node(const Model& model, const Pose& pose, int index, const std::string& where, traces::Mesh& out) {
  const Node& node = model.nodes[index];
  const std::string place = where + ": node \"" + node.name + "\"";
  std::vector<glm::dmat4> joints;
  if (node.skin >= 0) {
    const Skin& skin = model.skins[node.skin];
    for (std::size_t j = 0; j < skin.joints.size(); ++j)
      joints.push_back(pose.world[skin.joints[j]] * skin.inverse_bind[j]);
  }
  for (const Primitive& primitive : model.shapes[node.shape].primitives) {
    const Geometry& g = *primitive.geometry;
    const auto base = static_cast<std::uint32_t>(out.positions.size());
    Emitter emitter(place, out);
    const Morphed source{g, pose.weights[index]};
    const bool skinned = !joints.empty() && g.influences != 0;
    const bool mirrored =
        skinned ? emit_skinned(source, joints, emitter) : emit_rigid(source, pose.world[index], emitter);
    emitter.rest(primitive, mirrored, base);
  }
}

void grow(WorldBox& box, const traces::Mesh& mesh) {
  for (const std::uint32_t i : mesh.indices) {
    const traces::Vec3& p = mesh.positions[i];
    box.add({p.x, p.y, p.z});
  }
}

}  // namespace artu::sim
