#include "sim/driver/image_builder.h"

#include <algorithm>
#include <cstring>

#include "hw/frame_registers.h"
#include "traces/error.h"

namespace artu::sim {

namespace {

hw::Vector vector(traces::Vec3 v) { return {v.x, v.y, v.z}; }

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

ImageBuilder::ImageBuilder(const traces::Scene& scene, const hw::UnitConfig& unit, FrameFrom frames,
                           hw::MemoryImage& image, StaticTrees* trees)
    : scene_(scene),
      dynamic_trees_({unit.accel.dynamic_kind, unit.accel.leaf_size, unit.tree_builder}, std::move(frames)),
      image_(image),
      pitch_((scene.width + 63) / 64 * 64) {
  const std::uint64_t pixels = std::uint64_t{pitch_} * scene.height;
  frame_buffer_ = image_.allocate(pixels * 4);
  hit_classes_ = image_.allocate(pixels);
  if (unit.core.stack_overflow == hw::StackOverflow::spill) {
    stack_spills_ = image_.allocate(hw::Address{unit.core.count} * unit.core.contexts * hw::spill_bytes);
  }
  std::vector<hw::Address> textures;
  textures.reserve(scene.textures.size());
  for (const traces::Texture& texture : scene.textures) textures.push_back(add_texture(texture));
  materials_ = add_materials(textures);
  if (trees != nullptr) {
    static_ = lay_geometry(scene.static_geometry, trees->of(unit.accel), 0, image_);
  } else {
    static_ = lay_geometry(scene.static_geometry, build_static_tree(scene, unit.accel), 0, image_);
  }
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
  const DynamicTree built = dynamic_trees_.of(frame, where);
  dynamic_quality_ = quality_of(built.tree);
  // The tree builder's input and scratch memory: see FrameDescriptor.
  const hw::Address input = image_.allocate(count * 2 * 64);
  const hw::Address scratch = image_.allocate((built.tree.order.size() * 16 + 63) / 64 * 64 * 2);
  const auto static_count = static_cast<std::uint32_t>(scene_.static_geometry.triangle_count());
  const LaidGeometry dynamic = lay_geometry(frame.dynamic, built.tree, static_count, image_);
  // The root of one tree waits on the stack while the other is walked.
  stack_needed_ = std::max(static_.stack, dynamic.stack) + 1;

  hw::FrameDescriptor d{};
  d.width = scene_.width;
  d.height = scene_.height;
  describe(static_, dynamic, d);
  d.materials = materials_;
  d.lights = lights;
  d.frame_buffer = frame_buffer_;
  d.hit_classes = hit_classes_;
  d.build_input = input;
  d.build_scratch = scratch;
  d.stack_spills = stack_spills_;
  d.pitch = pitch_;
  d.light_count = static_cast<std::uint32_t>(frame.lights.size());
  d.dynamic_triangle_count = static_cast<std::uint32_t>(count);
  d.dynamic_reference_count = dynamic.references;
  d.dynamic_node_lines = dynamic.node_lines;
  d.dynamic_moved = built.moved ? 1 : 0;
  d.dynamic_refit = built.refitted ? 1 : 0;
  d.build = built.tree.work;
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
