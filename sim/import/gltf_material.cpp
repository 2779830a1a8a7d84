// Materials and textures of a glTF file.
#include <algorithm>
#include <cmath>

#include "sim/import/gltf_import.h"
#include "sim/import/gltf_texture.h"
#include "sim/import/surface.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using tinygltf::Value;

double number_or(const Value& object, const char* key, double otherwise) {
  if (!object.Has(key) || !object.Get(key).IsNumber()) return otherwise;
  const double v = object.Get(key).GetNumberAsDouble();
  return std::isfinite(v) ? v : otherwise;
}

double element_or(const Value& object, const char* key, int i, double otherwise) {
  if (!object.Has(key) || !object.Get(key).IsArray()) return otherwise;
  const Value& v = object.Get(key).Get(i);
  return v.IsNumber() && std::isfinite(v.GetNumberAsDouble()) ? v.GetNumberAsDouble() : otherwise;
}

int integer_or(const Value& object, const char* key, int otherwise) {
  const double v = number_or(object, key, otherwise);
  return std::abs(v) < 1e9 ? static_cast<int>(v) : otherwise;
}

double share(double v) { return v >= 0 ? std::min(v, 1.0) : 0.0; }
glm::dvec3 positive(const glm::dvec3& v) { return glm::clamp(v, 0.0, 1e6); }

/// A reference to a texture, wherever in a material it stands.
struct TextureRef {
  int index = -1, set = 0;
  Value transform;
};

TextureRef ref(const tinygltf::TextureInfo& info) {
  const auto transform = info.extensions.find("KHR_texture_transform");
  return {info.index, info.texCoord, transform == info.extensions.end() ? Value() : transform->second};
}

TextureRef ref(const Value& object, const char* key) {
  if (!object.Has(key) || !object.Get(key).IsObject()) return {};
  const Value& info = object.Get(key);
  TextureRef out;
  out.index = integer_or(info, "index", -1);
  out.set = integer_or(info, "texCoord", 0);
  if (info.Has("extensions") && info.Get("extensions").IsObject())
    out.transform = info.Get("extensions").Get("KHR_texture_transform");
  return out;
}

class MaterialReader {
 public:
  MaterialReader(const GltfFile& file, GltfTextures& textures) : file_(file), textures_(textures) {}

  /// What was simplified: one line a kind, however many materials it met.
  void report(std::vector<std::string>& log) const {
    for (const auto& [what, where] : notes_) {
      std::string list;
      for (std::size_t i = 0; i < where.size() && i < 8; ++i) list += (i ? ", " : "") + std::to_string(where[i]);
      log.push_back(file_.at("materials " + list + (where.size() > 8 ? ", ..." : "") + ": " + what));
    }
  }

  void read(std::size_t index, traces::Material& out, GltfTexcoords& texcoords) {
    const tinygltf::Material& source = file_.json.materials[index];
    where_ =
        file_.at("materials[" + std::to_string(index) + "]" + (source.name.empty() ? "" : " \"" + source.name + "\""));
    index_ = index;
    out.name = source.name.empty() ? "material " + std::to_string(index) : source.name;
    Surface surface;
    TextureRef color;
    double alpha = 1;
    const Value* glossy = extension(source, "KHR_materials_pbrSpecularGlossiness");
    if (glossy) {
      read_glossiness(*glossy, surface, color, alpha);
    } else {
      read_metallic(source.pbrMetallicRoughness, surface, color, alpha);
    }
    read_transmission(source, surface);
    read_alpha(source, color, alpha, surface);
    map_surface(surface, out);
    if (color.index >= 0) {
      out.texture = textures_.texture(color.index, where_);
      read_texcoords(color, texcoords);
    }
    read_emission(source, out);
    if (extension(source, "KHR_materials_unlit")) make_unlit(surface, out);
    if (source.normalTexture.index >= 0) note("a normal map is ignored");
  }

 private:
  static const Value* extension(const tinygltf::Material& m, const char* name) {
    const auto it = m.extensions.find(name);
    return it != m.extensions.end() && it->second.IsObject() ? &it->second : nullptr;
  }

  void note(const char* what) { notes_[what].push_back(index_); }

  void read_metallic(const tinygltf::PbrMetallicRoughness& pbr, Surface& s, TextureRef& color, double& alpha) {
    const auto& c = pbr.baseColorFactor;
    if (c.size() >= 3) s.base = positive({c[0], c[1], c[2]});
    if (c.size() >= 4) alpha = share(c[3]);
    s.metallic = share(pbr.metallicFactor);
    s.roughness = share(pbr.roughnessFactor);
    color = ref(pbr.baseColorTexture);
    const DecodedImage* image = textures_.image(pbr.metallicRoughnessTexture.index, where_);
    if (!image) return;
    const auto mean = image->mean();
    s.roughness *= mean[1];
    s.metallic *= mean[2];
    note("a metallic-roughness texture is reduced to its average");
  }

  void read_glossiness(const Value& e, Surface& s, TextureRef& color, double& alpha) {
    for (int i = 0; i < 3; ++i) {
      s.base[i] = element_or(e, "diffuseFactor", i, 1);
      s.f0[i] = element_or(e, "specularFactor", i, 1);
    }
    s.base = positive(s.base);
    alpha = share(element_or(e, "diffuseFactor", 3, 1));
    double gloss = share(number_or(e, "glossinessFactor", 1));
    color = ref(e, "diffuseTexture");
    if (const DecodedImage* image = textures_.image(ref(e, "specularGlossinessTexture").index, where_)) {
      const auto mean = image->mean_linear();
      s.f0 *= glm::dvec3(mean[0], mean[1], mean[2]);
      gloss *= mean[3];
      note("a specular-glossiness texture is reduced to its average");
    }
    s.f0 = glm::clamp(s.f0, 0.0, 1.0);
    s.roughness = 1 - gloss;
    s.base *= 1 - std::max({s.f0.x, s.f0.y, s.f0.z});  // as the extension says: no energy is made
  }

  void read_transmission(const tinygltf::Material& m, Surface& s) {
    const Value* ior = extension(m, "KHR_materials_ior");
    if (ior) {
      s.ior = number_or(*ior, "ior", 1.5);
      if (s.ior < 1) s.ior = 1.5;  // 0 means "reflects everything" in old specular-glossiness files
      const double r = (s.ior - 1) / (s.ior + 1);
      s.f0 = glm::dvec3(r * r);
    }
    const Value* e = extension(m, "KHR_materials_transmission");
    if (!e) return;
    s.transmission = share(number_or(*e, "transmissionFactor", 0));
    if (const DecodedImage* image = textures_.image(ref(*e, "transmissionTexture").index, where_)) {
      s.transmission *= image->mean()[0];
      note("a transmission texture is reduced to its average");
    }
    const Value* volume = extension(m, "KHR_materials_volume");
    const bool solid = ior || (volume && number_or(*volume, "thicknessFactor", 0) > 0);
    if (s.transmission > 0 && !solid) {
      // The specification: without a volume the surface is an infinitely thin sheet, and light goes straight on.
      s.ior = 1;
      note("transmission without a volume or an ior is a thin sheet: light is not bent");
    }
  }

  void read_alpha(const tinygltf::Material& m, const TextureRef& color, double alpha, Surface& s) {
    if (m.alphaMode == "MASK") note("alphaMode MASK is treated as opaque");
    if (m.alphaMode != "BLEND") return;
    if (alpha < 1 && s.transmission == 0) {
      s.transmission = 1 - alpha;
      s.ior = 1;
      note("alphaMode BLEND with a constant alpha becomes transmission that is not bent");
    } else if (color.index >= 0 && s.transmission == 0) {
      note("alphaMode BLEND with a texture's alpha is treated as opaque");
    }
  }

  void read_texcoords(const TextureRef& color, GltfTexcoords& out) {
    out.textured = true;
    out.set = color.set;
    const Value& t = color.transform;
    if (!t.IsObject()) return;
    for (int i = 0; i < 2; ++i) {
      out.offset[i] = element_or(t, "offset", i, 0);
      out.scale[i] = element_or(t, "scale", i, 1);
    }
    out.rotation = number_or(t, "rotation", 0);
    out.set = integer_or(t, "texCoord", out.set);
  }

  void read_emission(const tinygltf::Material& m, traces::Material& out) {
    glm::dvec3 emission(0.0);
    if (m.emissiveFactor.size() >= 3) emission = {m.emissiveFactor[0], m.emissiveFactor[1], m.emissiveFactor[2]};
    const Value* strength = extension(m, "KHR_materials_emissive_strength");
    if (strength) emission *= number_or(*strength, "emissiveStrength", 1);
    emission = positive(emission);
    if (emission != glm::dvec3(0.0)) {
      if (const DecodedImage* image = textures_.image(m.emissiveTexture.index, where_)) {
        const auto mean = image->mean_linear();
        emission *= glm::dvec3(mean[0], mean[1], mean[2]);
        note("an emissive texture is reduced to its average");
      }
    }
    out.emission = to_vec3(emission);
  }

  void make_unlit(const Surface& s, traces::Material& out) {
    out.specular = out.mirror = {};
    out.tint = false;
    if (out.texture < 0) {
      out.emission = to_vec3(s.base * (1 - s.transmission));
      out.diffuse = {};
    } else {
      out.diffuse = to_vec3(s.base * (1 - s.transmission));
      note("unlit with a texture is shown as diffuse, since emission has no texture");
    }
  }

  const GltfFile& file_;
  GltfTextures& textures_;
  std::string where_;
  std::size_t index_ = 0;
  std::map<std::string, std::vector<std::size_t>> notes_;
};

}  // namespace

std::vector<GltfTexcoords> import_gltf_materials(const GltfFile& file, GltfAccessors& accessors, Model& model,
                                                 std::vector<std::string>& log) {
  GltfTextures textures(file, accessors, model, log);
  MaterialReader reader(file, textures);
  std::vector<GltfTexcoords> texcoords(file.json.materials.size() + 1);
  model.materials.resize(file.json.materials.size() + 1);
  for (std::size_t m = 0; m < file.json.materials.size(); ++m) reader.read(m, model.materials[m], texcoords[m]);
  reader.report(log);
  // The specification's default material is a rough white metal; every viewer shows it as plain white.
  model.materials.back().name = "default";
  map_surface(Surface{}, model.materials.back());
  return texcoords;
}

}  // namespace artu::sim
