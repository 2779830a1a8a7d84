// A scene before it is posed: what glTF and OBJ files are read into and what a stage composes.
//
// Indices refer to the vectors of the same Model; -1 is "none".  Nodes are ordered so that a parent comes
// before its children, which makes every pass over the hierarchy one loop and a cycle impossible.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <string>
#include <vector>

#include "sim/import/animation.h"
#include "traces/frame.h"

namespace artu::sim {

/// Most triangles, and most vertices, that a posed scene may have: instancing can multiply a small file by a lot.
inline constexpr std::uint64_t max_scene_elements = std::uint64_t{1} << 25;

struct MorphTarget {
  std::vector<glm::vec3> positions;  // offsets; empty or one a vertex
  std::vector<glm::vec3> normals;
};

/// Triangles in the space of their node (or of the skin's bind pose).  `positions` sets the vertex count; the
/// other arrays are empty (absent) or as long.
struct Geometry {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  // absent: flat, which the unit does by itself for zero normals
  std::vector<glm::vec2> uvs;
  std::vector<std::uint32_t> colors;   // as in traces::Mesh
  std::vector<std::uint32_t> indices;  // three a triangle, all in range
  std::uint32_t influences = 0;        // joints a vertex; 0: not skinned
  std::vector<std::uint16_t> joints;   // `influences` a vertex: index into Skin::joints
  std::vector<float> weights;          // as many; they sum to 1
  std::vector<MorphTarget> targets;

  std::size_t triangle_count() const { return indices.size() / 3; }
};

/// Geometry is shared by primitives, nodes and copies of a file: instancing costs no memory before it is posed.
struct Primitive {
  std::shared_ptr<const Geometry> geometry;
  std::uint32_t material = 0;
};

struct Shape {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<double> weights;  // of the morph targets, at rest
};

struct Skin {
  std::string name;
  std::vector<int> joints;  // nodes
  std::vector<glm::dmat4> inverse_bind;
};

struct CameraLens {
  bool perspective = true;
  double fov = 0.785398163397448;  // vertical, radians
  double half_height = 1;          // orthographic
};

/// A light of a file, in its node's space (it shines along -z), in the file's unit of intensity.
struct NodeLight {
  traces::LightKind kind = traces::LightKind::point;
  glm::dvec3 color{1.0};                        // times intensity
  double range = 0;                             // 0: unlimited
  double inner = 0, outer = 0.785398163397448;  // spot: half angles, radians
};

/// A stage's word on whether a node's geometry is in the static or the dynamic tree.
enum class MotionOverride : std::uint8_t { none, force_static, force_dynamic };

struct Node {
  std::string name;
  int parent = -1;
  Trs local;
  bool has_matrix = false;  // `matrix` instead of `local`; never animated
  glm::dmat4 matrix{1.0};
  bool visible = true;  // false: outside the active scene, there only as a joint
  int shape = -1, skin = -1, camera = -1, light = -1;
  std::vector<double> weights;  // of the morph targets; empty: the shape's
  MotionOverride motion = MotionOverride::none;
};

/// A clip that plays: time runs as `start + speed * t`, modulo its length if `loop`, else clamped.
struct Player {
  Clip clip;
  double speed = 1, start = 0;
  bool loop = true;
};

struct Model {
  std::vector<Node> nodes;
  std::vector<Shape> shapes;
  std::vector<Skin> skins;
  std::vector<CameraLens> cameras;
  std::vector<NodeLight> lights;
  std::vector<traces::Material> materials;
  std::vector<traces::Texture> textures;
  std::vector<Clip> clips;      // what a file offers
  std::vector<Player> players;  // what plays; where two move the same node the later one wins
};

}  // namespace artu::sim
