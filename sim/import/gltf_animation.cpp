// Animations of a glTF file, as clips.
#include "sim/import/gltf_import.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

bool parse_path(const std::string& name, ChannelPath& path, std::size_t& width) {
  if (name == "translation") return path = ChannelPath::translation, width = 3, true;
  if (name == "rotation") return path = ChannelPath::rotation, width = 4, true;
  if (name == "scale") return path = ChannelPath::scale, width = 3, true;
  if (name == "weights") return path = ChannelPath::weights, width = 0, true;
  return false;
}

Interpolation parse_interpolation(const std::string& name, const std::string& where) {
  if (name.empty() || name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubic;
  throw InputError(where,
                   "interpolation \"" + name.substr(0, 40) + "\" is not supported; LINEAR, STEP or CUBICSPLINE is");
}

void read_keys(const tinygltf::AnimationSampler& sampler, GltfAccessors& accessors, const std::string& where,
               Channel& channel) {
  channel.interpolation = parse_interpolation(sampler.interpolation, where);
  const std::vector<float> times = accessors.floats(sampler.input, "1", where + ".input");
  if (times.empty()) throw InputError(where, "has no keys");
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (times[k] < times[k - 1])
      throw InputError(where, "key " + std::to_string(k) + " is earlier than the key before it");
  }
  const char* widths = channel.path == ChannelPath::weights ? "1" : channel.width == 4 ? "4" : "3";
  const std::vector<float> values = accessors.floats(sampler.output, widths, where + ".output");
  const std::size_t per_key = channel.width * (channel.interpolation == Interpolation::cubic ? 3 : 1);
  if (values.size() != times.size() * per_key)
    throw InputError(where, std::to_string(times.size()) + " keys need " + std::to_string(times.size() * per_key) +
                                " numbers of output, there are " + std::to_string(values.size()));
  channel.times.assign(times.begin(), times.end());
  channel.values.assign(values.begin(), values.end());
}

}  // namespace

void import_gltf_clips(const GltfFile& file, GltfAccessors& accessors, const std::vector<int>& node_of, Model& model,
                       std::vector<std::string>& log) {
  for (std::size_t a = 0; a < file.json.animations.size(); ++a) {
    const tinygltf::Animation& source = file.json.animations[a];
    Clip clip;
    clip.name = source.name;
    for (std::size_t c = 0; c < source.channels.size(); ++c) {
      const tinygltf::AnimationChannel& from = source.channels[c];
      const std::string where = file.at("animations[" + std::to_string(a) + "].channels[" + std::to_string(c) + "]");
      Channel channel;
      if (!parse_path(from.target_path, channel.path, channel.width)) {
        log.push_back(where + ": target path \"" + from.target_path.substr(0, 40) + "\" is ignored");
        continue;
      }
      if (from.target_node == -1) continue;  // the specification: such a channel is to be ignored
      if (from.target_node < 0 || static_cast<std::size_t>(from.target_node) >= node_of.size())
        throw InputError(where, "node " + std::to_string(from.target_node) + " does not exist; there are " +
                                    std::to_string(node_of.size()));
      if (from.sampler < 0 || static_cast<std::size_t>(from.sampler) >= source.samplers.size())
        throw InputError(where, "sampler " + std::to_string(from.sampler) + " does not exist; there are " +
                                    std::to_string(source.samplers.size()));
      channel.node = node_of[static_cast<std::size_t>(from.target_node)];
      if (channel.path == ChannelPath::weights) {
        const int shape = model.nodes[static_cast<std::size_t>(channel.node)].shape;
        channel.width = shape < 0 ? 0 : model.shapes[static_cast<std::size_t>(shape)].weights.size();
        if (channel.width == 0) {
          log.push_back(where + ": ignored, its node has no morph targets");
          continue;
        }
      }
      read_keys(source.samplers[static_cast<std::size_t>(from.sampler)], accessors, where, channel);
      clip.channels.push_back(std::move(channel));
    }
    clip.measure();
    model.clips.push_back(std::move(clip));
  }
}

}  // namespace artu::sim
