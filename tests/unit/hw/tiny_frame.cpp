#include "unit/hw/tiny_frame.h"

namespace artu::hw::test {

TinyFrame::TinyFrame(std::uint32_t width, std::uint32_t height) : width(width), height(height) {
  descriptor = image.allocate(sizeof(FrameDescriptor));
  FrameDescriptor f{};
  f.width = width;
  f.height = height;
  f.pitch = (width + 63) / 64 * 64;
  f.static_triangles = image.allocate(2 * 64);
  f.static_attributes = image.allocate(2 * 64);
  f.dynamic_triangles = image.allocate(64);
  f.dynamic_attributes = image.allocate(64);
  f.static_nodes = image.allocate(64);
  f.dynamic_nodes = image.allocate(64);
  f.materials = image.allocate(2 * sizeof(MaterialRecord));
  f.lights = image.allocate(sizeof(LightRecord));
  f.frame_buffer = image.allocate(std::uint64_t{f.pitch} * height * 4);
  f.hit_classes = image.allocate(std::uint64_t{f.pitch} * height);
  f.build_input = image.allocate(64);
  f.build_scratch = image.allocate(64);
  f.light_count = 1;
  f.dynamic_triangle_count = f.dynamic_reference_count = f.dynamic_node_lines = 1;
  // The camera looks down the z axis from z = 10 and sees x, y = -5 ... 5 at z = 0.
  f.camera.origin = {0, 0, 10};
  f.camera.corner = {-1, 1, -2};
  f.camera.du = {2 / static_cast<float>(width), 0, 0};
  f.camera.dv = {0, -2 / static_cast<float>(height), 0};
  f.ambient = {0.1f, 0.1f, 0.1f};
  f.sky_nadir = {0.1f, 0.2f, 0.3f};
  f.sky_zenith = {0.4f, 0.6f, 0.9f};
  // A wall below y = 1 in two triangles under one node; a triangle before it, which casts a shadow on it.
  f.static_root = NodeReference::inner(0, false);
  f.static_lo = {-20, -20, 0};
  f.static_hi = {20, 1, 0};
  f.dynamic_root = NodeReference::leaf(0, 1, true);
  f.dynamic_lo = {0, -2, 2};
  f.dynamic_hi = {3, 3, 2};
  image.at<FrameDescriptor>(descriptor) = f;

  auto& node = image.at<NodeRecord>(f.static_nodes);
  for (std::uint32_t i = 0; i < 2; ++i) {
    node.lo[i] = f.static_lo;
    node.hi[i] = f.static_hi;
    node.child[i] = NodeReference::leaf(i, 1, false);
  }
  const auto triangle = [this](Address triangles, Address attributes, Vector a, Vector b, Vector c,
                               std::uint32_t primitive, std::uint32_t material) {
    auto& record = image.at<TriangleRecord>(triangles);
    record.a = a;
    record.b = b;
    record.c = c;
    record.primitive = primitive;
    record.material = material;
    for (std::uint32_t& color : record.color) color = 0xffffffffu;
    for (Vector& normal : image.at<AttributeRecord>(attributes).normal) normal = {0, 0, 1};
  };
  triangle(f.static_triangles, f.static_attributes, {-20, -20, 0}, {20, -20, 0}, {20, 1, 0}, 0, 0);
  triangle(f.static_triangles + 64, f.static_attributes + 64, {-20, -20, 0}, {20, 1, 0}, {-20, 1, 0}, 1, 0);
  triangle(f.dynamic_triangles, f.dynamic_attributes, {0, -2, 2}, {3, -2, 2}, {0, 3, 2}, 2, 1);

  auto& wall = image.at<MaterialRecord>(f.materials);
  wall.diffuse = {0.8f, 0.6f, 0.4f};
  wall.ior = 1;
  auto& mirror = image.at<MaterialRecord>(f.materials + sizeof(MaterialRecord));
  mirror.diffuse = {0.2f, 0.2f, 0.6f};
  mirror.mirror = {0.5f, 0.5f, 0.5f};
  mirror.ior = 1;
  auto& light = image.at<LightRecord>(f.lights);
  light.type = LightType::point;
  light.position = {3, 3, 8};
  light.color = {60, 60, 60};
  light.range = 100;
}

TinyUnit::TinyUnit(std::uint32_t width, std::uint32_t height, const RunMode& mode, const UnitConfig& config,
                   const Fault& fault)
    : tiny(width, height), records(std::size_t{width} * height), unit("unit", config, mode, tiny.image, fault) {}

UnitConfig TinyUnit::small() {
  UnitConfig config;
  config.core.count = 2;
  config.core.contexts = 8;
  config.watchdog = 10000;
  return config;
}

FrameResult TinyUnit::run() {
  context.enter();
  records.assign(records.size(), {});
  return unit.run(tiny.descriptor, &records);
}

std::vector<PixelTuple> TinyUnit::pixels() const {
  std::vector<PixelTuple> result;
  for (const PixelRecord& r : records) {
    result.emplace_back(r.pass, static_cast<int>(r.hit_class), r.n_static, r.n_dynamic, r.threshold, r.difference,
                        static_cast<int>(r.decision), r.r, r.g, r.b, r.primitive, r.t_bits);
  }
  return result;
}

std::uint64_t TinyUnit::statistic(const FrameResult& result, const std::string& block, const std::string& name) const {
  for (const Statistic& s : result.statistics) {
    if (s.block == block && s.name == name) return s.value;
  }
  ADD_FAILURE() << "no statistic " << block << "." << name;
  return 0;
}

}  // namespace artu::hw::test
