#include "sim/import/stage_motion.h"

#include <algorithm>
#include <cmath>

#include "traces/error.h"

namespace artu::sim {
namespace {

struct Key {
  double time;
  glm::dvec3 position, rotation, scale;  // rotation: Euler degrees
};

void add(Channel& channel, double time, const glm::dvec3& v) {
  channel.times.push_back(time);
  channel.values.insert(channel.values.end(), {v.x, v.y, v.z});
}

void add(Channel& channel, double time, const glm::dquat& q) {
  channel.times.push_back(time);
  channel.values.insert(channel.values.end(), {q.x, q.y, q.z, q.w});
}

}  // namespace

glm::dquat euler(const glm::dvec3& degrees) {
  const glm::dvec3 half = glm::radians(degrees) * 0.5;
  const glm::dquat x(std::cos(half.x), std::sin(half.x), 0, 0), y(std::cos(half.y), 0, std::sin(half.y), 0),
      z(std::cos(half.z), 0, 0, std::sin(half.z));
  return z * y * x;
}

Trs read_placement(const StageTable& table, const Trs& rest) {
  Trs out = rest;
  out.translation = table.vector("position", rest.translation);
  if (table.has("rotation")) out.rotation = euler(table.vector("rotation", {}));
  out.scale = table.vector_or_number("scale", rest.scale);
  return out;
}

std::optional<Player> read_motion(const StageTable& table, int node, const Trs& rest, bool loop) {
  const std::vector<StageTable> tables = table.tables("key", {"time", "position", "rotation", "scale"});
  if (tables.empty()) return std::nullopt;
  std::vector<Key> keys;
  bool moves = false, turns = false, scales = false;
  Key now{0, rest.translation, table.vector("rotation", {}), rest.scale};
  for (const StageTable& key : tables) {
    if (!key.has("time")) throw InputError(key.where(), "[[key]]: time (seconds) is missing");
    now.time = key.number("time", 0, 0, 1e9);
    if (!keys.empty() && now.time <= keys.back().time) key.fail("time", "must be later than that of the key before");
    now.position = key.vector("position", now.position);
    now.rotation = key.vector("rotation", now.rotation);
    now.scale = key.vector_or_number("scale", now.scale);
    moves = moves || key.has("position");
    turns = turns || key.has("rotation");
    scales = scales || key.has("scale");
    keys.push_back(now);
  }
  Channel position, rotation, scale;
  position.node = rotation.node = scale.node = node;
  rotation.path = ChannelPath::rotation;
  rotation.width = 4;
  scale.path = ChannelPath::scale;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    add(position, keys[k].time, keys[k].position);
    add(scale, keys[k].time, keys[k].scale);
    if (k > 0) {
      // Angles, not quaternions, run evenly between keys, so that 0 to 360 is a full turn: small steps make it so.
      const glm::dvec3 from = keys[k - 1].rotation, to = keys[k].rotation;
      const double widest = std::max({std::abs(to.x - from.x), std::abs(to.y - from.y), std::abs(to.z - from.z)});
      const int steps = static_cast<int>(std::min(std::ceil(widest / 10), 36000.0));
      for (int s = 1; s < steps; ++s) {
        const double part = static_cast<double>(s) / steps;
        add(rotation, glm::mix(keys[k - 1].time, keys[k].time, part), euler(glm::mix(from, to, part)));
      }
    }
    add(rotation, keys[k].time, euler(keys[k].rotation));
  }
  Player player;
  player.loop = loop;
  player.clip.name = "keys";
  if (moves) player.clip.channels.push_back(position);
  if (turns) player.clip.channels.push_back(rotation);
  if (scales) player.clip.channels.push_back(scale);
  player.clip.measure();
  return player;
}

}  // namespace artu::sim
