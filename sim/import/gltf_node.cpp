// The node hierarchy, skins, cameras and lights of a glTF file.
#include <algorithm>
#include <cmath>

#include "sim/import/gltf_import.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

std::string node_place(std::size_t n) { return "nodes[" + std::to_string(n) + "]"; }

void check_index(int index, std::size_t size, const std::string& what, const std::string& where) {
  if (index < -1 || index >= static_cast<int>(size))
    throw InputError(where, what + " " + std::to_string(index) + " does not exist; there are " + std::to_string(size));
}

void check_finite(const std::vector<double>& v, const std::string& where) {
  for (const double x : v) {
    // Beyond this the products of a hierarchy's matrices leave even binary64.
    if (!(std::abs(x) < 1e30)) throw InputError(where, "a number of its transform is not finite or over 1e30");
  }
}

void check_length(const std::vector<double>& v, std::size_t length, const char* name, const std::string& where) {
  if (!v.empty() && v.size() != length)
    throw InputError(where, std::string(name) + " has " + std::to_string(v.size()) + " numbers, it must have " +
                                std::to_string(length));
  check_finite(v, where);
}

Node convert(const GltfFile& file, std::size_t index, const Model& model) {
  const tinygltf::Node& source = file.json.nodes[index];
  const std::string where = file.at(node_place(index));
  Node node;
  node.name = source.name.empty() ? node_place(index) : source.name;
  check_length(source.translation, 3, "translation", where);
  check_length(source.rotation, 4, "rotation", where);
  check_length(source.scale, 3, "scale", where);
  check_length(source.matrix, 16, "matrix", where);
  check_finite(source.weights, where);
  if (!source.matrix.empty()) {
    node.has_matrix = true;
    for (int i = 0; i < 16; ++i) node.matrix[i / 4][i % 4] = source.matrix[static_cast<std::size_t>(i)];
  }
  if (!source.translation.empty())
    node.local.translation = {source.translation[0], source.translation[1], source.translation[2]};
  if (!source.scale.empty()) node.local.scale = {source.scale[0], source.scale[1], source.scale[2]};
  if (!source.rotation.empty()) {
    const auto& q = source.rotation;
    const glm::dquat rotation(q[3], q[0], q[1], q[2]);
    if (glm::length(rotation) > 0) node.local.rotation = glm::normalize(rotation);
  }
  check_index(source.mesh, file.json.meshes.size(), "mesh", where);
  check_index(source.skin, file.json.skins.size(), "skin", where);
  check_index(source.camera, file.json.cameras.size(), "camera", where);
  node.shape = source.mesh;
  node.skin = source.mesh >= 0 ? source.skin : -1;
  node.camera = source.camera;
  if (source.mesh >= 0 && !source.weights.empty()) {
    node.weights = source.weights;
    node.weights.resize(model.shapes[source.mesh].weights.size());
  }
  const auto light = source.extensions.find("KHR_lights_punctual");
  if (light != source.extensions.end() && light->second.Has("light")) {
    const tinygltf::Value& index = light->second.Get("light");
    if (!index.IsInt()) throw InputError(where, "light is not a whole number");
    node.light = index.GetNumberAsInt();
    check_index(node.light, file.json.lights.size(), "light", where);
  }
  return node;
}

/// The parent of each node, -1 for roots.
std::vector<int> parents(const GltfFile& file) {
  const auto& nodes = file.json.nodes;
  std::vector<int> parent(nodes.size(), -1);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const std::string where = file.at(node_place(n));
    for (const int child : nodes[n].children) {
      if (child < 0) throw InputError(where, "child " + std::to_string(child) + " is not a node");
      check_index(child, nodes.size(), "child", where);
      if (child == static_cast<int>(n)) throw InputError(where, "is its own child: the hierarchy must be a tree");
      if (parent[child] >= 0)
        throw InputError(file.at(node_place(static_cast<std::size_t>(child))),
                         "is a child of both " + node_place(static_cast<std::size_t>(parent[child])) + " and " +
                             node_place(n) + ": the hierarchy must be a tree");
      parent[child] = static_cast<int>(n);
    }
  }
  return parent;
}

}  // namespace

std::vector<int> import_gltf_nodes(const GltfFile& file, Model& model) {
  const auto& nodes = file.json.nodes;
  const std::vector<int> parent = parents(file);

  // Roots of the scene that is shown; without any scene, all roots.
  std::vector<char> shown(nodes.size(), file.json.scenes.empty());
  if (!file.json.scenes.empty()) {
    const int scene = std::max(file.json.defaultScene, 0);
    check_index(scene, file.json.scenes.size(), "scene", file.path);
    for (const int root : file.json.scenes[static_cast<std::size_t>(scene)].nodes) {
      if (root < 0) throw InputError(file.path, "scene root " + std::to_string(root) + " is not a node");
      check_index(root, nodes.size(), "scene root", file.path);
      shown[static_cast<std::size_t>(root)] = 1;
    }
  }

  // Depth first, parents before children, with a stack of our own: files decide how deep it goes.
  std::vector<int> node_of(nodes.size(), -1), stack;
  for (std::size_t n = nodes.size(); n-- > 0;) {
    if (parent[n] < 0) stack.push_back(static_cast<int>(n));
  }
  while (!stack.empty()) {
    const auto n = static_cast<std::size_t>(stack.back());
    stack.pop_back();
    Node node = convert(file, n, model);
    node.parent = parent[n] < 0 ? -1 : node_of[static_cast<std::size_t>(parent[n])];
    node.visible = shown[n] || (node.parent >= 0 && model.nodes[static_cast<std::size_t>(node.parent)].visible);
    node_of[n] = static_cast<int>(model.nodes.size());
    model.nodes.push_back(std::move(node));
    const auto& children = nodes[n].children;
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    // Every node has at most one parent, so what no root reaches is a ring.
    if (node_of[n] < 0)
      throw InputError(file.at(node_place(n)), "is its own ancestor (node cycle): the hierarchy must be a tree");
  }
  return node_of;
}

void import_gltf_skins(const GltfFile& file, GltfAccessors& accessors, const std::vector<int>& node_of, Model& model) {
  for (std::size_t s = 0; s < file.json.skins.size(); ++s) {
    const tinygltf::Skin& source = file.json.skins[s];
    const std::string where = file.at("skins[" + std::to_string(s) + "]");
    Skin skin;
    skin.name = source.name;
    if (source.joints.empty()) throw InputError(where, "has no joints");
    for (const int joint : source.joints) {
      if (joint < 0) throw InputError(where, "joint " + std::to_string(joint) + " is not a node");
      check_index(joint, node_of.size(), "joint", where);
      skin.joints.push_back(node_of[static_cast<std::size_t>(joint)]);
    }
    skin.inverse_bind.assign(skin.joints.size(), glm::dmat4(1.0));
    if (source.inverseBindMatrices >= 0) {
      const std::size_t count = accessors.count(source.inverseBindMatrices, where);
      if (count < skin.joints.size())
        throw InputError(where, "has " + std::to_string(count) + " inverse bind matrices for " +
                                    std::to_string(skin.joints.size()) + " joints; it needs one a joint");
      const std::vector<float> m = accessors.floats(source.inverseBindMatrices, "@", where + ".inverseBindMatrices");
      for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        for (int i = 0; i < 16; ++i) skin.inverse_bind[j][i / 4][i % 4] = m[16 * j + static_cast<std::size_t>(i)];
      }
    }
    model.skins.push_back(std::move(skin));
  }
  for (const Node& node : model.nodes) {
    if (node.skin < 0) continue;
    const std::size_t joints = model.skins[static_cast<std::size_t>(node.skin)].joints.size();
    for (const Primitive& p : model.shapes[static_cast<std::size_t>(node.shape)].primitives) {
      for (const std::uint16_t joint : p.geometry->joints) {
        if (joint >= joints)
          throw InputError(
              file.at("node \"" + node.name + "\""),
              "a vertex uses joint " + std::to_string(joint) + " of a skin with " + std::to_string(joints) + " joints");
      }
    }
  }
}

void import_gltf_cameras_and_lights(const GltfFile& file, Model& model, std::vector<std::string>& log) {
  for (std::size_t c = 0; c < file.json.cameras.size(); ++c) {
    const tinygltf::Camera& source = file.json.cameras[c];
    const std::string where = file.at("cameras[" + std::to_string(c) + "]");
    CameraLens lens;
    lens.perspective = source.type != "orthographic";
    lens.fov = source.perspective.yfov;
    lens.half_height = std::abs(source.orthographic.ymag);
    if (lens.perspective && !(lens.fov > 0 && lens.fov < 3.14159))
      throw InputError(where, "yfov is " + std::to_string(lens.fov) + "; it must be between 0 and pi radians");
    if (!lens.perspective && !(lens.half_height > 0 && lens.half_height < 1e15))
      throw InputError(where, "ymag must be above 0");
    model.cameras.push_back(lens);
  }
  for (std::size_t l = 0; l < file.json.lights.size(); ++l) {
    const tinygltf::Light& source = file.json.lights[l];
    const std::string where = file.at("lights[" + std::to_string(l) + "]");
    NodeLight light;
    if (source.type == "directional") {
      light.kind = traces::LightKind::directional;
    } else if (source.type == "spot") {
      light.kind = traces::LightKind::spot;
    } else if (source.type != "point") {
      throw InputError(where, "type is \"" + source.type + "\"; point, spot or directional is allowed");
    }
    if (source.color.size() >= 3) light.color = {source.color[0], source.color[1], source.color[2]};
    light.color *= source.intensity;
    for (int i = 0; i < 3; ++i) {
      if (!(light.color[i] >= 0 && light.color[i] < 1e30))
        throw InputError(where, "color times intensity must be 0 or more");
    }
    light.range = source.range > 0 ? source.range : 0;
    light.inner = source.spot.innerConeAngle;
    light.outer = source.spot.outerConeAngle;
    if (light.kind == traces::LightKind::spot &&
        !(light.inner >= 0 && light.inner <= light.outer && light.outer <= 1.5708))
      log.push_back(where + ": cone angles are not 0 <= inner <= outer <= pi/2; they are clamped");
    light.outer = std::clamp(light.outer, 1e-3, 1.5707963);
    light.inner = std::clamp(light.inner, 0.0, light.outer);
    model.lights.push_back(light);
  }
}

}  // namespace artu::sim
