#include "traces/pack.h"

#include <algorithm>

#include "traces/limits.h"
#include "traces/wire.h"

namespace artu::traces {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

template <typename T>
void send(FlatBufferBuilder& builder, fb::Body kind, Offset<T> body, const ChunkSink& sink) {
  fb::FinishChunkBuffer(builder, fb::CreateChunk(builder, format_version, kind, body.Union()));
  sink(builder.GetBufferPointer(), builder.GetSize());
}

/// A builder that writes default values too: what is in a file does not depend on the schema's defaults.
class Builder : public FlatBufferBuilder {
 public:
  explicit Builder(std::size_t size = 1024) : FlatBufferBuilder(size) { ForceDefaults(true); }
};

void pack_header(const Scene& scene, const ChunkSink& sink) {
  Builder b;
  const auto name = b.CreateString(scene.name);
  const auto generator = b.CreateString(scene.generator);
  const Mesh& mesh = scene.static_geometry;
  send(b, fb::Body_Header,
       fb::CreateHeader(
           b, name, generator, scene.width, scene.height, scene.fps, scene.frame_count,
           static_cast<std::uint32_t>(scene.materials.size()), static_cast<std::uint32_t>(scene.textures.size()),
           static_cast<std::uint32_t>(mesh.positions.size()), static_cast<std::uint32_t>(mesh.triangle_count())),
       sink);
}

void pack_materials(const Scene& scene, const ChunkSink& sink) {
  Builder b;
  std::vector<Offset<fb::Material>> materials;
  materials.reserve(scene.materials.size());
  for (const Material& m : scene.materials) {
    const fb::Vec3 diffuse = wire(m.diffuse), specular = wire(m.specular), mirror = wire(m.mirror),
                   transmission = wire(m.transmission), emission = wire(m.emission);
    materials.push_back(fb::CreateMaterial(b, b.CreateString(m.name), &diffuse, &specular, m.specular_log2, &mirror,
                                           &transmission, m.ior, &emission, m.texture, m.tint));
  }
  send(b, fb::Body_Materials, fb::CreateMaterials(b, b.CreateVector(materials)), sink);
}

void pack_texture(const Texture& t, const ChunkSink& sink) {
  Builder b(t.rgba.size() + t.name.size() + 1024);
  const auto rgba = b.CreateVector(t.rgba);
  const auto name = b.CreateString(t.name);
  send(b, fb::Body_Texture,
       fb::CreateTexture(b, name, t.width, t.height, static_cast<fb::Wrap>(t.wrap_u), static_cast<fb::Wrap>(t.wrap_v),
                         rgba),
       sink);
}

/// Elements of `all` that belong to a part, `per` of them for each of the part's vertices or triangles.
template <typename T>
std::pair<const T*, std::size_t> slice(const std::vector<T>& all, std::uint32_t part, std::size_t per = 1) {
  const std::size_t begin = std::min(all.size(), per * part_elements * part);
  return {all.data() + begin, std::min(all.size() - begin, per * part_elements)};
}

template <typename To, typename From>
auto structs(FlatBufferBuilder& b, std::pair<const From*, std::size_t> s) {
  // NOLINTNEXTLINE(misc-redundant-expression): they are of two types.
  static_assert(sizeof(To) == sizeof(From) && alignof(To) == alignof(From));
  return b.CreateVectorOfStructs(reinterpret_cast<const To*>(s.first), s.second);
}

auto numbers(FlatBufferBuilder& b, std::pair<const std::uint32_t*, std::size_t> s) {
  return b.CreateVector(s.first, s.second);
}

void pack_mesh(const Mesh& mesh, fb::Body kind, const ChunkSink& sink) {
  const std::uint32_t parts = part_count(mesh.positions.size(), mesh.triangle_count());
  for (std::uint32_t part = 0; part < parts; ++part) {
    const auto positions = slice(mesh.positions, part);
    const auto materials = slice(mesh.materials, part);
    Builder b(positions.second * 36 + materials.second * 16 + 1024);
    const auto positions_at = structs<fb::Vec3>(b, positions);
    const auto normals_at = structs<fb::Vec3>(b, slice(mesh.normals, part));
    const auto uvs_at = structs<fb::Vec2>(b, slice(mesh.uvs, part));
    const auto colors_at = numbers(b, slice(mesh.colors, part));
    const auto indices_at = numbers(b, slice(mesh.indices, part, 3));
    const auto materials_at = numbers(b, materials);
    send(b, kind, fb::CreateMeshPart(b, part, positions_at, normals_at, uvs_at, colors_at, indices_at, materials_at),
         sink);
  }
}

}  // namespace

void pack(const Scene& scene, const ChunkSink& sink) {
  pack_header(scene, sink);
  pack_materials(scene, sink);
  for (const Texture& texture : scene.textures) pack_texture(texture, sink);
  pack_mesh(scene.static_geometry, fb::Body_StaticPart, sink);
}

void pack(const Frame& frame, const ChunkSink& sink) {
  Builder b;
  std::vector<Offset<fb::Light>> lights;
  for (const Light& l : frame.lights) {
    const fb::Vec3 position = wire(l.position), direction = wire(l.direction), color = wire(l.color);
    lights.push_back(fb::CreateLight(b, static_cast<fb::LightKind>(l.kind), &position, &direction, &color, l.range,
                                     l.cos_inner, l.cos_outer));
  }
  const auto lights_at = b.CreateVector(lights);
  const fb::Camera camera = wire(frame.camera);
  const fb::Vec3 ambient = wire(frame.ambient), nadir = wire(frame.sky_nadir), zenith = wire(frame.sky_zenith);
  send(b, fb::Body_Frame,
       fb::CreateFrame(b, frame.index, frame.time, &camera, lights_at, &ambient, &nadir, &zenith, frame.dynamic_moved,
                       static_cast<std::uint32_t>(frame.dynamic.positions.size()),
                       static_cast<std::uint32_t>(frame.dynamic.triangle_count())),
       sink);
  pack_mesh(frame.dynamic, fb::Body_DynamicPart, sink);
}

}  // namespace artu::traces
