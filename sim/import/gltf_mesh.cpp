// Primitives: vertex attributes, indices of every triangle mode, influences, morph targets.
#include <algorithm>
#include <cmath>

#include "sim/import/gltf_import.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using Attributes = std::map<std::string, int>;

int attribute(const Attributes& attributes, const std::string& name) {
  const auto it = attributes.find(name);
  return it == attributes.end() ? -1 : it->second;
}

std::uint32_t code(float v) { return static_cast<std::uint32_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255.0f)); }

class PrimitiveReader {
 public:
  PrimitiveReader(GltfAccessors& accessors, const tinygltf::Primitive& source, const std::string& where,
                  std::vector<std::string>& log)
      : accessors_(accessors), source_(source), where_(where), log_(log) {}

  std::shared_ptr<const Geometry> read(const GltfTexcoords& texcoords) {
    Geometry g;
    g.positions = vec3s(attribute(source_.attributes, "POSITION"), "POSITION", 0);
    count_ = g.positions.size();
    const int normal = attribute(source_.attributes, "NORMAL");
    if (normal >= 0) g.normals = vec3s(normal, "NORMAL", count_);
    if (texcoords.textured) read_uvs(texcoords, g);
    read_colors(g);
    read_indices(g);
    read_influences(g);
    read_targets(g);
    return std::make_shared<const Geometry>(std::move(g));
  }

 private:
  std::string at(const std::string& name) const { return where_ + "." + name; }

  void same_count(std::size_t count, const std::string& name) const {
    if (count != count_)
      throw InputError(at(name), "has " + std::to_string(count) + " elements, POSITION has " + std::to_string(count_));
  }

  std::vector<glm::vec3> vec3s(int accessor, const std::string& name, std::size_t expected) {
    // Before it is decoded, so that a wrong count costs no memory.
    if (expected) same_count(accessors_.count(accessor, at(name)), name);
    const std::vector<float> v = accessors_.floats(accessor, "3", at(name));
    std::vector<glm::vec3> out(v.size() / 3);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
    return out;
  }

  void read_uvs(const GltfTexcoords& t, Geometry& g) {
    const std::string name = "TEXCOORD_" + std::to_string(t.set);
    const int accessor = attribute(source_.attributes, name);
    if (accessor < 0) {
      log_.push_back(where_ + " has a texture but no " + name + ": one texel is used for all of it");
      return;
    }
    same_count(accessors_.count(accessor, at(name)), name);
    const std::vector<float> v = accessors_.floats(accessor, "2", at(name));
    const double c = std::cos(t.rotation), s = std::sin(t.rotation);
    g.uvs.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      // KHR_texture_transform: offset * rotation * scale
      const double u = v[2 * i] * t.scale[0], w = v[2 * i + 1] * t.scale[1];
      g.uvs[i] = {static_cast<float>(c * u + s * w + t.offset[0]), static_cast<float>(-s * u + c * w + t.offset[1])};
      if (!(std::abs(g.uvs[i].x) <= 1048576.0f && std::abs(g.uvs[i].y) <= 1048576.0f))
        throw InputError(at(name),
                         "element " + std::to_string(i) + " is over 2^20; texture coordinates are near 0 ... 1");
    }
  }

  void read_colors(Geometry& g) {
    const int accessor = attribute(source_.attributes, "COLOR_0");
    if (accessor < 0) return;
    same_count(accessors_.count(accessor, at("COLOR_0")), "COLOR_0");
    const std::vector<float> v = accessors_.floats(accessor, "34", at("COLOR_0"));
    const std::size_t width = v.size() / std::max<std::size_t>(count_, 1);
    g.colors.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      const float* p = &v[i * width];
      const std::uint32_t alpha = width == 4 ? code(p[3]) : 255;
      g.colors[i] = code(p[0]) | code(p[1]) << 8 | code(p[2]) << 16 | alpha << 24;
    }
  }

  void read_indices(Geometry& g) {
    std::vector<std::uint32_t> corners;
    if (source_.indices >= 0) {
      corners = accessors_.integers(source_.indices, "1", at("indices"));
      for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] >= count_)
          throw InputError(at("indices"), "index " + std::to_string(corners[i]) + " (element " + std::to_string(i) +
                                              ") is not below the vertex count " + std::to_string(count_));
      }
    } else {
      corners.resize(count_);
      for (std::size_t i = 0; i < count_; ++i) corners[i] = static_cast<std::uint32_t>(i);
    }
    const std::size_t n = corners.size();
    if (source_.mode == TINYGLTF_MODE_TRIANGLE_STRIP || source_.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
      const bool fan = source_.mode == TINYGLTF_MODE_TRIANGLE_FAN;
      for (std::size_t i = 0; i + 2 < n; ++i) {
        const std::uint32_t a = corners[fan ? 0 : i];
        // Every second triangle of a strip has its first two corners swapped back.
        const std::uint32_t b = corners[fan ? i + 1 : i + 1 + i % 2], c = corners[fan ? i + 2 : i + 2 - i % 2];
        g.indices.insert(g.indices.end(), {a, b, c});
      }
    } else {
      if (n % 3 != 0)
        log_.push_back(where_ + ": " + std::to_string(n % 3) + " corners after the last whole triangle are ignored");
      corners.resize(n - n % 3);
      g.indices = std::move(corners);
    }
  }

  void read_influences(Geometry& g) {
    std::vector<std::vector<std::uint32_t>> joints;
    std::vector<std::vector<float>> weights;
    for (int set = 0; set < 8; ++set) {
      const std::string j = "JOINTS_" + std::to_string(set), w = "WEIGHTS_" + std::to_string(set);
      const int joint = attribute(source_.attributes, j), weight = attribute(source_.attributes, w);
      if (joint < 0 && weight < 0) break;
      if (joint < 0 || weight < 0) throw InputError(where_, j + " and " + w + " must come together");
      same_count(accessors_.count(joint, at(j)), j);
      same_count(accessors_.count(weight, at(w)), w);
      joints.push_back(accessors_.integers(joint, "4", at(j)));
      weights.push_back(accessors_.floats(weight, "4", at(w)));
    }
    g.influences = static_cast<std::uint32_t>(4 * joints.size());
    g.joints.reserve(g.influences * count_);
    g.weights.reserve(g.influences * count_);
    for (std::size_t v = 0; v < count_ && g.influences; ++v) {
      double sum = 0;
      for (const auto& set : weights) {
        for (int k = 0; k < 4; ++k) sum += std::max(set[4 * v + k], 0.0f);
      }
      for (std::size_t set = 0; set < joints.size(); ++set) {
        for (int k = 0; k < 4; ++k) {
          const std::uint32_t joint = joints[set][4 * v + k];
          const float raw = std::max(weights[set][4 * v + k], 0.0f);
          // A vertex that nothing holds would fall to the origin: its first joint takes it.
          const float w = sum > 0 ? static_cast<float>(raw / sum) : (set == 0 && k == 0 ? 1.0f : 0.0f);
          if (w > 0 && joint > 65535)
            throw InputError(where_, "joint " + std::to_string(joint) + " of vertex " + std::to_string(v) +
                                         " is over the limit of 65535");
          g.joints.push_back(w > 0 ? static_cast<std::uint16_t>(joint) : std::uint16_t{0});
          g.weights.push_back(w);
        }
      }
    }
  }

  void read_targets(Geometry& g) {
    for (std::size_t t = 0; t < source_.targets.size(); ++t) {
      const std::string name = "targets[" + std::to_string(t) + "]";
      MorphTarget target;
      const int position = attribute(source_.targets[t], "POSITION"), normal = attribute(source_.targets[t], "NORMAL");
      if (position >= 0) target.positions = vec3s(position, name + ".POSITION", count_);
      if (normal >= 0 && !g.normals.empty()) target.normals = vec3s(normal, name + ".NORMAL", count_);
      g.targets.push_back(std::move(target));
    }
  }

  GltfAccessors& accessors_;
  const tinygltf::Primitive& source_;
  const std::string& where_;
  std::vector<std::string>& log_;
  std::size_t count_ = 0;
};

/// Two primitives with the same key have the same Geometry.
std::string geometry_key(const tinygltf::Primitive& p, const GltfTexcoords& t) {
  std::string key = std::to_string(p.indices) + "/" + std::to_string(p.mode);
  for (const auto& [name, accessor] : p.attributes) key += "/" + name + "=" + std::to_string(accessor);
  for (const auto& target : p.targets) {
    key += "/target";
    for (const auto& [name, accessor] : target) key += "/" + name + "=" + std::to_string(accessor);
  }
  if (!t.textured) return key;
  key += "/uv" + std::to_string(t.set);
  for (const double x : {t.offset[0], t.offset[1], t.scale[0], t.scale[1], t.rotation}) key += "," + std::to_string(x);
  return key;
}

}  // namespace

void import_gltf_meshes(const GltfFile& file, GltfAccessors& accessors, const std::vector<GltfTexcoords>& texcoords,
                        Model& model, std::vector<std::string>& log) {
  std::map<std::string, std::shared_ptr<const Geometry>> known;
  for (std::size_t m = 0; m < file.json.meshes.size(); ++m) {
    const tinygltf::Mesh& source = file.json.meshes[m];
    Shape shape;
    shape.name = source.name;
    std::size_t targets = 0;
    for (std::size_t p = 0; p < source.primitives.size(); ++p) {
      const tinygltf::Primitive& primitive = source.primitives[p];
      const std::string where = file.at("meshes[" + std::to_string(m) + "].primitives[" + std::to_string(p) + "]");
      const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
      if (mode > TINYGLTF_MODE_TRIANGLE_FAN)
        throw InputError(where, "mode " + std::to_string(mode) + "; 0 ... 6 is allowed");
      if (mode < TINYGLTF_MODE_TRIANGLES) {
        log.push_back(where + ": points and lines are skipped, the unit has triangles only");
        continue;
      }
      if (attribute(primitive.attributes, "POSITION") < 0) {
        log.push_back(where + ": skipped, it has no POSITION");
        continue;
      }
      if (primitive.material >= static_cast<int>(file.json.materials.size()))
        throw InputError(where, "material " + std::to_string(primitive.material) + " does not exist; there are " +
                                    std::to_string(file.json.materials.size()));
      const std::size_t material = primitive.material < 0 ? texcoords.size() - 1 : primitive.material;
      auto& geometry = known[geometry_key(primitive, texcoords[material])];
      if (!geometry) geometry = PrimitiveReader(accessors, primitive, where, log).read(texcoords[material]);
      targets = std::max(targets, primitive.targets.size());
      shape.primitives.push_back({geometry, static_cast<std::uint32_t>(material)});
    }
    shape.weights = source.weights;
    shape.weights.resize(targets);
    model.shapes.push_back(std::move(shape));
  }
}

}  // namespace artu::sim
