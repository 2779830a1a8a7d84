#include "sim/driver/image_builder.h"

#include <algorithm>
#include <cstring>

#include "hw/frame_registers.h"
#include "traces/error.h"

namespace artu::sim {

namespace {

hw::Vector vector(traces::Vec3 v) { return {v.x, v.y, v.z}; }

hw::TriangleRecord triangle_record(const traces::Mesh& mesh, std::size_t triangle, std::uint32_t id,
                                   std::uint32_t attributes) {
  const std::uint32_t* index = &mesh.indices[3 * triangle];
  hw::TriangleRecord record{};
  record.a = vector(mesh.positions[index[0]]);
  record.b = vector(mesh.positions[index[1]]);
  record.c = vector(mesh.positions[index[2]]);
  record.primitive = id;
  record.material = mesh.materials[triangle];
  record.attributes = attributes;
  for (int i = 0; i < 3; ++i) record.color[i] = mesh.colors[index[i]];
  return record;
}

hw::AttributeRecord attribute_record(const traces::Mesh& mesh, std::size_t triangle) {
  hw::AttributeRecord record{};
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t index = mesh.indices[3 * triangle + static_cast<std::size_t>(i)];
    record.normal[i] = vector(mesh.normals[index]);
    record.uv[i][0] = mesh.uvs[index].x;
    record.uv[i][1] = mesh.uvs[index].y;
  }
  return record;
}

hw::LightRecord light_record(const traces::Light& light) {
  hw::LightRecord record{};
  record.position = vector(light.position);
  record.direction = vector(light.direction);
  record.color = vector(light.color);
  record.range = light.range;
  record.cos_inner = light.cos_inner;
  record.cos_outer = light.cos_outer;
  record.type = static_cast<hw::LightType>(light.kind);
  return record;
}

}  // namespace

ImageBuilder::ImageBuilder(const traces::Scene& scene, const hw::AccelConfig& accel, hw::MemoryImage& image)
    : scene_(scene), accel_(accel), image_(image), pitch_((scene.width + 63) / 64 * 64) {
  const std::uint64_t pixels = std::uint64_t{pitch_} * scene.height;
  frame_buffer_ = image_.allocate(pixels * 4);
  hit_classes_ = image_.allocate(pixels);
  std::vector<hw::Address> textures;
  textures.reserve(scene.textures.size());
  for (const traces::Texture& texture : scene.textures) textures.push_back(add_texture(texture));
  materials_ = add_materials(textures);
  static_ = add_geometry(scene.static_geometry, accel.static_kind, false, 0, scene.name + ": static geometry");
  shared_top_ = image_.size();
}

hw::Address ImageBuilder::add_texture(const traces::Texture& texture) {
  const std::uint64_t tiles = std::uint64_t{(texture.width + 3) / 4} * ((texture.height + 3) / 4);
  const hw::Address base = image_.allocate(tiles * 64);
  for (std::uint32_t y = 0; y < texture.height; ++y) {
    for (std::uint32_t x = 0; x < texture.width; ++x) {
      std::memcpy(&image_.at<std::uint8_t>(hw::texel_address(base, texture.width, x, y)),
                  &texture.rgba[(std::size_t{y} * texture.width + x) * 4], 4);
    }
  }
  return base;
}

hw::Address ImageBuilder::add_materials(const std::vector<hw::Address>& textures) {
  const hw::Address base = image_.allocate(scene_.materials.size() * sizeof(hw::MaterialRecord));
  for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
    const traces::Material& material = scene_.materials[i];
    auto& record = image_.at<hw::MaterialRecord>(base + i * sizeof(hw::MaterialRecord));
    record.diffuse = vector(material.diffuse);
    record.specular = vector(material.specular);
    record.mirror = vector(material.mirror);
    record.transmission = vector(material.transmission);
    record.emission = vector(material.emission);
    record.ior = material.ior;
    record.specular_log2 = material.specular_log2;
    record.tint = material.tint ? 1 : 0;
    if (material.texture >= 0) {
      const auto index = static_cast<std::size_t>(material.texture);
      const traces::Texture& texture = scene_.textures[index];
      record.texels = textures[index];
      record.width = texture.width;
      record.height = texture.height;
      record.wrap_u = static_cast<hw::TextureWrap>(texture.wrap_u);
      record.wrap_v = static_cast<hw::TextureWrap>(texture.wrap_v);
    }
  }
  return base;
}

ImageBuilder::Geometry ImageBuilder::add_geometry(const traces::Mesh& mesh, hw::TreeKind kind, bool dynamic,
                                                  std::uint32_t first_id, const std::string& where) {
  Geometry geometry;
  geometry.tree = build_tree(mesh, kind, dynamic, where);
  Tree& tree = geometry.tree;
  geometry.nodes = image_.allocate(tree.nodes.size());
  if (!tree.nodes.empty()) std::memcpy(&image_.at<std::uint8_t>(geometry.nodes), tree.nodes.data(), tree.nodes.size());
  geometry.triangles = image_.allocate(tree.order.size() * sizeof(hw::TriangleRecord));
  geometry.attributes = image_.allocate(mesh.triangle_count() * sizeof(hw::AttributeRecord));
  // Attributes lie in the order in which the leaves first name their triangles: a BVH's have the same index as these.
  constexpr std::uint32_t unplaced = ~std::uint32_t{0};
  std::vector<std::uint32_t> place(mesh.triangle_count(), unplaced);
  std::uint32_t placed = 0;
  for (std::size_t i = 0; i < tree.order.size(); ++i) {
    const std::uint32_t triangle = tree.order[i];
    if (place[triangle] == unplaced) {
      place[triangle] = placed++;
      image_.at<hw::AttributeRecord>(geometry.attributes + place[triangle] * sizeof(hw::AttributeRecord)) =
          attribute_record(mesh, triangle);
    }
    image_.at<hw::TriangleRecord>(geometry.triangles + i * sizeof(hw::TriangleRecord)) =
        triangle_record(mesh, triangle, first_id + triangle, place[triangle]);
  }
  geometry.node_lines = static_cast<std::uint32_t>((tree.nodes.size() + 63) / 64);
  geometry.references = static_cast<std::uint32_t>(tree.order.size());
  tree.nodes = {};
  tree.order = {};
  return geometry;
}

hw::Address ImageBuilder::add(const traces::Frame& frame) {
  const std::string where = scene_.name + ": frame " + std::to_string(frame.index);
  if (frame.lights.size() > hw::maximum_lights) {
    throw InputError(where, std::to_string(frame.lights.size()) + " lights; the unit has room for " +
                                std::to_string(hw::maximum_lights));
  }
  image_.shrink(shared_top_);
  const hw::Address at = image_.allocate(sizeof(hw::FrameDescriptor));
  const hw::Address lights = image_.allocate(frame.lights.size() * sizeof(hw::LightRecord));
  for (std::size_t i = 0; i < frame.lights.size(); ++i) {
    image_.at<hw::LightRecord>(lights + i * sizeof(hw::LightRecord)) = light_record(frame.lights[i]);
  }
  const std::size_t count = frame.dynamic.triangle_count();
  // The builder's input: triangles in the mesh's order, a line each; its scratch: 16 bytes a triangle.
  const hw::Address input = image_.allocate(count * 64);
  const hw::Address scratch = image_.allocate(count * 16);
  const Geometry dynamic = add_geometry(frame.dynamic, accel_.dynamic_kind, true,
                                        static_cast<std::uint32_t>(scene_.static_geometry.triangle_count()), where);
  // The root of one tree waits on the stack while the other is walked.
  stack_needed_ = std::max(static_.tree.stack, dynamic.tree.stack) + 1;

  hw::FrameDescriptor d{};
  d.width = scene_.width;
  d.height = scene_.height;
  d.static_kind = static_.tree.kind;
  d.dynamic_kind = dynamic.tree.kind;
  d.static_root = static_.tree.root;
  d.dynamic_root = dynamic.tree.root;
  d.static_lo = static_.tree.lo;
  d.static_hi = static_.tree.hi;
  d.dynamic_lo = dynamic.tree.lo;
  d.dynamic_hi = dynamic.tree.hi;
  d.static_nodes = static_.nodes;
  d.dynamic_nodes = dynamic.nodes;
  d.static_triangles = static_.triangles;
  d.dynamic_triangles = dynamic.triangles;
  d.static_attributes = static_.attributes;
  d.dynamic_attributes = dynamic.attributes;
  d.materials = materials_;
  d.lights = lights;
  d.frame_buffer = frame_buffer_;
  d.hit_classes = hit_classes_;
  d.build_input = input;
  d.build_scratch = scratch;
  d.pitch = pitch_;
  d.light_count = static_cast<std::uint32_t>(frame.lights.size());
  d.dynamic_triangle_count = static_cast<std::uint32_t>(count);
  d.dynamic_reference_count = dynamic.references;
  d.dynamic_node_lines = dynamic.node_lines;
  d.dynamic_moved = frame.dynamic_moved ? 1 : 0;
  const traces::Camera& camera = frame.camera;
  d.camera = {vector(camera.origin), vector(camera.origin_du), vector(camera.origin_dv),
              vector(camera.corner), vector(camera.du),        vector(camera.dv)};
  d.ambient = vector(frame.ambient);
  d.sky_nadir = vector(frame.sky_nadir);
  d.sky_zenith = vector(frame.sky_zenith);
  image_.at<hw::FrameDescriptor>(at) = d;
  return at;
}

}  // namespace artu::sim
