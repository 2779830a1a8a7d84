#include "sim/import/pose.h"

#include <algorithm>

namespace artu::sim {
namespace {

void apply(const Channel& channel, double time, Trs& local, std::vector<double>& weights) {
  switch (channel.path) {
    case ChannelPath::translation:
      channel.sample(time, &local.translation.x);
      break;
    case ChannelPath::rotation: {
      double q[4];
      channel.sample(time, q);
      local.rotation = glm::dquat(q[3], q[0], q[1], q[2]);
      break;
    }
    case ChannelPath::scale:
      channel.sample(time, &local.scale.x);
      break;
    case ChannelPath::weights:
      if (channel.width == weights.size()) channel.sample(time, weights.data());
      break;
  }
}

}  // namespace

Pose pose_at(const Model& model, double time) {
  std::vector<Trs> local(model.nodes.size());
  Pose pose;
  pose.weights.resize(model.nodes.size());
  std::vector<char> uses_matrix(model.nodes.size());
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    const Node& node = model.nodes[n];
    local[n] = node.local;
    uses_matrix[n] = node.has_matrix;
    if (node.shape >= 0) pose.weights[n] = node.weights.empty() ? model.shapes[node.shape].weights : node.weights;
  }
  for (const Player& player : model.players) {
    const double inside = clip_time(player.start + player.speed * time, player.clip.length, player.loop);
    for (const Channel& channel : player.clip.channels) {
      const auto n = static_cast<std::size_t>(channel.node);
      if (channel.path != ChannelPath::weights) uses_matrix[n] = false;
      apply(channel, inside, local[n], pose.weights[n]);
    }
  }
  pose.world.resize(model.nodes.size());
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    const Node& node = model.nodes[n];
    const glm::dmat4 own = uses_matrix[n] ? node.matrix : local[n].matrix();
    pose.world[n] = node.parent < 0 ? own : pose.world[node.parent] * own;
  }
  return pose;
}

}  // namespace artu::sim
