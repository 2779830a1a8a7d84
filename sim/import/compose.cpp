#include "sim/import/compose.h"

namespace artu::sim {
namespace {

int shift(int index, std::size_t by) { return index < 0 ? index : index + static_cast<int>(by); }

}  // namespace

Appended append(Model& whole, const Model& part, const Node& root) {
  const std::size_t nodes = whole.nodes.size() + 1, shapes = whole.shapes.size(), skins = whole.skins.size(),
                    cameras = whole.cameras.size(), lights = whole.lights.size(), textures = whole.textures.size();
  const auto materials = static_cast<std::uint32_t>(whole.materials.size());
  whole.nodes.push_back(root);
  for (Node node : part.nodes) {
    node.parent = node.parent < 0 ? static_cast<int>(nodes) - 1 : shift(node.parent, nodes);
    node.shape = shift(node.shape, shapes);
    node.skin = shift(node.skin, skins);
    node.camera = shift(node.camera, cameras);
    node.light = shift(node.light, lights);
    whole.nodes.push_back(std::move(node));
  }
  for (Shape shape : part.shapes) {
    for (Primitive& p : shape.primitives) p.material += materials;
    whole.shapes.push_back(std::move(shape));
  }
  for (Skin skin : part.skins) {
    for (int& joint : skin.joints) joint = shift(joint, nodes);
    whole.skins.push_back(std::move(skin));
  }
  for (traces::Material material : part.materials) {
    material.texture = shift(material.texture, textures);
    whole.materials.push_back(std::move(material));
  }
  for (Player player : part.players) {
    for (Channel& channel : player.clip.channels) channel.node = shift(channel.node, nodes);
    whole.players.push_back(std::move(player));
  }
  whole.cameras.insert(whole.cameras.end(), part.cameras.begin(), part.cameras.end());
  whole.lights.insert(whole.lights.end(), part.lights.begin(), part.lights.end());
  whole.textures.insert(whole.textures.end(), part.textures.begin(), part.textures.end());
  return {static_cast<int>(nodes) - 1, materials};
}

}  // namespace artu::sim
