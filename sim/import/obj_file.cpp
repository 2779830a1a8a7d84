#include "sim/import/obj_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "sim/import/image.h"
#include "sim/import/obj_check.h"
#include "sim/import/resource_path.h"
#include "sim/import/surface.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr std::uint64_t max_obj = std::uint64_t{1} << 32;

std::string_view text_of(const std::vector<std::uint8_t>& bytes) {
  return without_byte_order_mark({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// MTL files from the scene's own folder; one that is missing is a log line, since many OBJ files go without.
class FolderMaterials : public tinyobj::MaterialReader {
 public:
  FolderMaterials(const std::string& obj, std::vector<std::string>& log) : obj_(obj), log_(log) {}

  bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* by_name, std::string* warning, std::string* error) override {
    try {
      const std::string path = resource_path(folder_of(obj_), name, obj_ + ": mtllib");
      const std::vector<std::uint8_t> bytes = read_file(path, max_obj);
      std::istringstream text{std::string(text_of(bytes))};
      tinyobj::LoadMtl(by_name, materials, &text, warning, error);
      return true;
    } catch (const InputError& e) {
      log_.push_back(std::string(e.what()) + "; the default material is used");
      return false;
    }
  }

 private:
  const std::string& obj_;
  std::vector<std::string>& log_;
};

class ObjTextures {
 public:
  ObjTextures(const std::string& obj, Model& model) : obj_(obj), model_(model) {}

  int load(std::string name, bool clamp, const std::string& where) {
    std::replace(name.begin(), name.end(), '\\', '/');  // written on Windows
    const std::string key = (clamp ? "c" : "r") + name;
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    const std::string path = resource_path(folder_of(obj_), name, where);
    const std::vector<std::uint8_t> bytes = read_file(path, max_obj);
    DecodedImage image = decode_image(bytes.data(), bytes.size(), path);
    // OBJ counts v from the bottom row, the unit from the top: the importer turns v around, not the picture.
    traces::Texture texture;
    texture.name = name;
    texture.width = image.width;
    texture.height = image.height;
    texture.wrap_u = texture.wrap_v = clamp ? traces::Wrap::clamp : traces::Wrap::repeat;
    texture.rgba = std::move(image.rgba);
    model_.textures.push_back(std::move(texture));
    return known_[key] = static_cast<int>(model_.textures.size()) - 1;
  }

 private:
  const std::string& obj_;
  Model& model_;
  std::map<std::string, int> known_;
};

glm::dvec3 color(const tinyobj::real_t* c) {
  glm::dvec3 v(c[0], c[1], c[2]);
  for (int i = 0; i < 3; ++i) v[i] = v[i] >= 0 && v[i] < 1e6 ? v[i] : 0;
  return v;
}

traces::Material convert(const tinyobj::material_t& m, ObjTextures& textures, const std::string& path,
                         std::vector<std::string>& log) {
  const std::string where = path + ": material \"" + m.name + "\"";
  traces::Material out;
  out.name = m.name;
  glm::dvec3 diffuse = color(m.diffuse), specular = color(m.specular);
  if (!m.diffuse_texname.empty()) {
    out.texture = textures.load(m.diffuse_texname, m.diffuse_texopt.clamp, where);
    // Many exporters write black under a map and mean the map.
    if (diffuse == glm::dvec3(0.0)) diffuse = glm::dvec3(1.0);
  }
  const double opaque = std::clamp(static_cast<double>(m.dissolve), 0.0, 1.0);
  const bool glass = m.illum == 4 || m.illum == 6 || m.illum == 7 || m.illum == 9;
  double through = 1 - opaque;
  if (glass && through == 0)
    through = std::min(std::max({m.transmittance[0], m.transmittance[1], m.transmittance[2]}), tinyobj::real_t(1));
  const double ior = m.ior >= 0.25 && m.ior <= 4 ? static_cast<double>(m.ior) : 1.0;
  out.diffuse = to_vec3(diffuse * (1 - through));
  if (through > 0) {
    const glm::dvec3 filter = color(m.transmittance);
    out.transmission = to_vec3((filter != glm::dvec3(0.0) ? filter : glm::dvec3(1.0)) * through);
    out.ior = static_cast<float>(ior);
    log.push_back(where + ": transmits " + std::to_string(through).substr(0, 4) + " of the light, ior " +
                  std::to_string(ior).substr(0, 4));
  }
  const double shininess = std::isfinite(m.shininess) ? std::clamp(static_cast<double>(m.shininess), 1.0, 1024.0) : 1.0;
  out.specular_log2 = static_cast<std::uint32_t>(std::lround(std::log2(shininess)));
  if (m.illum != 0 && m.illum != 1) out.specular = to_vec3(specular);
  if (m.illum == 3 || m.illum == 5) out.mirror = to_vec3(glm::min(specular, glm::dvec3(1.0)));
  out.emission = to_vec3(color(m.emission));
  return out;
}

/// Corners of one material, made into vertices: equal corners become one.
class GeometryBuilder {
 public:
  explicit GeometryBuilder(const tinyobj::attrib_t& attrib) : attrib_(attrib) {}

  void corner(const tinyobj::index_t& i, const glm::vec3& normal) {
    const std::array<float, 3> n{normal.x, normal.y, normal.z};
    const auto [it, is_new] = known_.try_emplace({i.vertex_index, i.texcoord_index, n}, geometry_.positions.size());
    if (is_new) {
      const auto v = 3 * static_cast<std::size_t>(i.vertex_index);
      geometry_.positions.push_back({attrib_.vertices[v], attrib_.vertices[v + 1], attrib_.vertices[v + 2]});
      geometry_.normals.push_back(normal);
      const auto t = 2 * static_cast<std::size_t>(std::max(i.texcoord_index, 0));
      geometry_.uvs.push_back(i.texcoord_index < 0 ? glm::vec2(0.0f)
                                                   : glm::vec2(attrib_.texcoords[t], 1 - attrib_.texcoords[t + 1]));
    }
    geometry_.indices.push_back(static_cast<std::uint32_t>(it->second));
  }

  Geometry take() { return std::move(geometry_); }
  bool empty() const { return geometry_.indices.empty(); }

 private:
  struct Key {
    int vertex, texcoord;
    std::array<float, 3> normal;
    bool operator<(const Key& o) const {
      return std::tie(vertex, texcoord, normal) < std::tie(o.vertex, o.texcoord, o.normal);
    }
  };
  const tinyobj::attrib_t& attrib_;
  std::map<Key, std::size_t> known_;
  Geometry geometry_;
};

/// That check_obj() has counted as tinyobjloader does: what lies behind these arrays must not be read.
void check_corner(const tinyobj::index_t& i, const tinyobj::attrib_t& a) {
  const auto within = [](int index, int least, std::size_t numbers, std::size_t width) {
    return index >= least && index < static_cast<long long>(numbers / width);
  };
  const bool fine = within(i.vertex_index, 0, a.vertices.size(), 3) &&
                    within(i.normal_index, -1, a.normals.size(), 3) &&
                    within(i.texcoord_index, -1, a.texcoords.size(), 2);
  if (!fine) throw std::logic_error("a corner of a face is not there");
}

void check_finite(const std::vector<tinyobj::real_t>& v, std::size_t width, double limit, const char* what,
                  const std::string& path) {
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (!(std::abs(v[i]) < limit))
      throw InputError(
          path, std::string(what) + " " + std::to_string(i / width + 1) + " is not a finite number or too large");
  }
}

}  // namespace

Model import_obj(const std::string& path, std::vector<std::string>& log) {
  const std::vector<std::uint8_t> bytes = read_file(path, max_obj);
  const std::uint64_t triangles = check_obj(text_of(bytes), path);
  std::istringstream text{std::string(text_of(bytes))};
  tinyobj::attrib_t attrib;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  FolderMaterials reader(path, log);
  if (!tinyobj::LoadObj(&attrib, &shapes, &materials, &warning, &error, &text, &reader, true, false))
    throw InputError(path, "not a valid OBJ file: " + error.substr(0, error.find('\n')));
  check_finite(attrib.vertices, 3, 1e18, "vertex", path);
  check_finite(attrib.normals, 3, 1e18, "normal", path);
  check_finite(attrib.texcoords, 2, 1048575, "texture coordinate", path);

  Model model;
  ObjTextures textures(path, model);
  for (const auto& m : materials) model.materials.push_back(convert(m, textures, path, log));
  const std::size_t fallback = model.materials.size();
  model.materials.emplace_back();
  model.materials.back().name = "default";

  // All corners of the file at once, so that smoothing does not stop at group borders.
  std::vector<glm::vec3> positions(attrib.vertices.size() / 3);
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] = {attrib.vertices[3 * v], attrib.vertices[3 * v + 1], attrib.vertices[3 * v + 2]};
  std::vector<std::uint32_t> corners;
  bool missing = false;
  for (const auto& shape : shapes) {
    for (const auto& i : shape.mesh.indices) {
      check_corner(i, attrib);
      corners.push_back(static_cast<std::uint32_t>(i.vertex_index));
      missing = missing || i.normal_index < 0;
    }
  }
  if (corners.empty()) throw InputError(path, "has no face; one with faces would be right");
  if (corners.size() / 3 < triangles) {
    log.push_back(
        fmt::format("{}: lacks {} of {} triangles: faces of more than three corners that cannot be cut into "
                    "triangles, or that come before their corners",
                    path, triangles - corners.size() / 3, triangles));
  }
  std::vector<glm::vec3> made;
  if (missing) {
    made = crease_normals(positions, corners);
    log.push_back(path + ": has faces without normals; they are made, smooth up to 60 degrees");
  }

  std::vector<GeometryBuilder> builders(model.materials.size(), GeometryBuilder(attrib));
  std::size_t corner = 0;
  for (const auto& shape : shapes) {
    for (std::size_t k = 0; k < shape.mesh.indices.size(); ++k, ++corner) {
      const int material = k / 3 < shape.mesh.material_ids.size() ? shape.mesh.material_ids[k / 3] : -1;
      const tinyobj::index_t& i = shape.mesh.indices[k];
      glm::vec3 normal = missing ? made[corner] : glm::vec3(0.0f);
      if (i.normal_index >= 0) {
        const auto n = 3 * static_cast<std::size_t>(i.normal_index);
        normal = {attrib.normals[n], attrib.normals[n + 1], attrib.normals[n + 2]};
      }
      const bool known = material >= 0 && static_cast<std::size_t>(material) < fallback;
      builders[known ? static_cast<std::size_t>(material) : fallback].corner(i, normal);
    }
  }
  Shape shape;
  for (std::size_t m = 0; m < builders.size(); ++m) {
    if (builders[m].empty()) continue;
    shape.primitives.push_back({std::make_shared<const Geometry>(builders[m].take()), static_cast<std::uint32_t>(m)});
  }
  model.shapes.push_back(std::move(shape));
  Node node;
  node.name = "obj";
  node.shape = 0;
  model.nodes.push_back(node);
  return model;
}

}  // namespace artu::sim
