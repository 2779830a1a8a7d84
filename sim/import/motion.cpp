#include "sim/import/motion.h"

namespace artu::sim {

std::vector<char> dynamic_nodes(const Model& model) {
  const std::size_t count = model.nodes.size();
  std::vector<char> moves(count), morphs(count);
  for (const Player& player : model.players) {
    for (const Channel& channel : player.clip.channels) {
      // Speed 0 stands still; keys that are all alike do too.
      if (player.speed == 0 || !channel.varies()) continue;
      (channel.path == ChannelPath::weights ? morphs : moves)[channel.node] = 1;
    }
  }
  for (std::size_t n = 0; n < count; ++n) {
    const int parent = model.nodes[n].parent;
    if (parent >= 0 && moves[parent]) moves[n] = 1;
  }
  std::vector<char> dynamic(count);
  std::vector<MotionOverride> override_(count, MotionOverride::none);
  for (std::size_t n = 0; n < count; ++n) {
    const Node& node = model.nodes[n];
    // An override holds for the node and all below it that have none of their own.
    override_[n] = node.motion;
    if (node.motion == MotionOverride::none && node.parent >= 0) override_[n] = override_[node.parent];
    if (node.shape < 0) continue;
    bool moving = moves[n];
    if (node.skin >= 0) {  // a skinned mesh goes where its joints go; its own node does not matter
      moving = false;
      for (const int joint : model.skins[node.skin].joints) moving = moving || moves[joint];
    }
    bool has_targets = false;
    for (const Primitive& p : model.shapes[node.shape].primitives) has_targets |= !p.geometry->targets.empty();
    moving = moving || (morphs[n] && has_targets);
    if (override_[n] == MotionOverride::force_static) moving = false;
    if (override_[n] == MotionOverride::force_dynamic) moving = true;
    dynamic[n] = moving;
  }
  return dynamic;
}

}  // namespace artu::sim
