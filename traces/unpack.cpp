#include "traces/unpack.h"

#include <algorithm>
#include <utility>

#include "traces/error.h"
#include "traces/limits.h"

namespace artu::traces {
namespace {

// Chunk, body, list, element: nothing lies deeper.  A table is at least 8 bytes, but many offsets may
// point at one of them; so the number that is looked at is limited, too.
constexpr flatbuffers::uoffset_t max_depth = 8;
constexpr flatbuffers::uoffset_t max_tables = max_materials + 8;

const char* kind_name(fb::Body kind) {
  const char* name = fb::EnumNameBody(kind);
  return *name ? name : "unknown";
}

bool has_identifier(const Bytes& bytes) {
  return bytes.size() >= 8 && std::memcmp(bytes.data() + 4, fb::ChunkIdentifier(), 4) == 0;
}

template <typename T>
void append_bytes(std::vector<T>& to, const std::uint8_t* from, std::size_t count) {
  const std::size_t old = to.size();
  to.resize(old + count);
  if (count > 0) std::memcpy(static_cast<void*>(to.data() + old), from, count * sizeof(T));
}

void append(std::vector<std::uint32_t>& to, const flatbuffers::Vector<std::uint32_t>& from) {
  append_bytes(to, from.Data(), from.size());
}

template <typename To, typename From>
void append(std::vector<To>& to, const flatbuffers::Vector<const From*>& from) {
  static_assert(sizeof(To) == sizeof(From));
  append_bytes(to, from.Data(), from.size());
}

/// Elements of a part when the whole has `total`.
std::uint32_t part_size(std::uint32_t number, std::uint32_t total) {
  const std::uint64_t begin = std::uint64_t{number} * part_elements;
  return begin >= total ? 0 : static_cast<std::uint32_t>(std::min<std::uint64_t>(part_elements, total - begin));
}

}  // namespace

Chunk::Chunk(Bytes bytes, fb::Body kind, std::string where) : bytes_(std::move(bytes)), where_(std::move(where)) {
  if (!has_identifier(bytes_)) fail("is not a trace's: its bytes 4 to 7, decompressed, must be \"ARTU\"");
  // The version first: of another version's chunk nothing but this field can be understood.
  flatbuffers::Verifier peek(bytes_.data(), bytes_.size(), max_depth, max_tables);
  if (!peek.VerifyBuffer<fb::AnyVersion>(fb::ChunkIdentifier())) fail("is not a valid FlatBuffer");
  const std::uint32_t version = flatbuffers::GetRoot<fb::AnyVersion>(bytes_.data())->version();
  if (version != format_version) {
    fail("trace version " + std::to_string(version) + ", this program reads " + std::to_string(format_version));
  }
  flatbuffers::Verifier verifier(bytes_.data(), bytes_.size(), max_depth, max_tables);
  if (!fb::VerifyChunkBuffer(verifier)) fail("is not a valid FlatBuffer of the trace's schema");
  root_ = fb::GetChunk(bytes_.data());
  if (root_->body_type() != kind) {
    fail(std::string("is of kind ") + kind_name(root_->body_type()) + "; " + kind_name(kind) + " must be here");
  }
}

void Chunk::fail(const std::string& what) const { throw InputError(where_, what); }

void Chunk::check_count(const char* what, std::uint64_t count, std::uint64_t most) const {
  if (count > most) {
    fail(std::string(what) + " is " + std::to_string(count) + "; must be at most " + std::to_string(most));
  }
}

void Chunk::check_size(const char* array, std::size_t size, std::size_t expected) const {
  if (size != expected) {
    fail(std::string(array) + " has " + std::to_string(size) + " elements; must have " + std::to_string(expected));
  }
}

std::string Chunk::text(const char* what, const flatbuffers::String& text) const {
  if (text.size() > max_text) {
    fail(std::string(what) + " has " + std::to_string(text.size()) + " bytes; must have at most " +
         std::to_string(max_text));
  }
  return text.str();
}

void Chunk::header(Scene& scene, HeaderCounts& counts) const {
  const fb::Header& h = *root_->body_as_Header();
  check_count("material_count", h.material_count(), max_materials);
  check_count("texture_count", h.texture_count(), max_textures);
  check_count("static_vertices", h.static_vertices(), max_elements);
  check_count("static_triangles", h.static_triangles(), max_elements);
  counts = {h.material_count(), h.texture_count(), h.static_vertices(), h.static_triangles()};
  scene.name = text("name", *h.name());
  scene.generator = text("generator", *h.generator());
  scene.width = h.width();
  scene.height = h.height();
  scene.fps = h.fps();
  scene.frame_count = h.frame_count();
}

void Chunk::materials(Scene& scene, std::uint32_t count) const {
  const auto& list = *root_->body_as_Materials()->materials();
  check_size("materials", list.size(), count);
  for (const fb::Material* m : list) {
    Material& to = scene.materials.emplace_back();
    to.name = text("a material's name", *m->name());
    to.diffuse = plain(*m->diffuse());
    to.specular = plain(*m->specular());
    to.specular_log2 = m->specular_log2();
    to.mirror = plain(*m->mirror());
    to.transmission = plain(*m->transmission());
    to.ior = m->ior();
    to.emission = plain(*m->emission());
    to.texture = m->texture();
    to.tint = m->tint();
  }
}

void Chunk::texture(Scene& scene) const {
  const fb::Texture& t = *root_->body_as_Texture();
  Texture& to = scene.textures.emplace_back();
  to.name = text("name", *t.name());
  to.width = t.width();
  to.height = t.height();
  to.wrap_u = static_cast<Wrap>(t.wrap_u());
  to.wrap_v = static_cast<Wrap>(t.wrap_v());
  to.rgba.assign(t.rgba()->Data(), t.rgba()->Data() + t.rgba()->size());
}

void Chunk::frame(Frame& frame, FrameCounts& counts) const {
  const fb::Frame& f = *root_->body_as_Frame();
  check_count("dynamic_vertices", f.dynamic_vertices(), max_elements);
  check_count("dynamic_triangles", f.dynamic_triangles(), max_elements);
  check_count("the number of lights", f.lights()->size(), max_lights);
  counts = {f.dynamic_vertices(), f.dynamic_triangles()};
  frame.index = f.index();
  frame.time = f.time();
  frame.camera = plain(*f.camera());
  for (const fb::Light* l : *f.lights()) {
    frame.lights.push_back({static_cast<LightKind>(l->kind()), plain(*l->position()), plain(*l->direction()),
                            plain(*l->color()), l->range(), l->cos_inner(), l->cos_outer()});
  }
  frame.ambient = plain(*f.ambient());
  frame.sky_nadir = plain(*f.sky_nadir());
  frame.sky_zenith = plain(*f.sky_zenith());
  frame.dynamic_moved = f.dynamic_moved();
}

void Chunk::part(Mesh& mesh, std::uint32_t number, std::uint32_t vertices, std::uint32_t triangles) const {
  const fb::Body kind = root_->body_type();
  const fb::MeshPart& p = kind == fb::Body_StaticPart ? *root_->body_as_StaticPart() : *root_->body_as_DynamicPart();
  if (p.part() != number) {
    fail("is part " + std::to_string(p.part()) + " of its mesh; part " + std::to_string(number) + " must be here");
  }
  const std::size_t of_vertices = part_size(number, vertices), of_triangles = part_size(number, triangles);
  check_size("positions", p.positions()->size(), of_vertices);
  check_size("normals", p.normals()->size(), of_vertices);
  check_size("uvs", p.uvs()->size(), of_vertices);
  check_size("colors", p.colors()->size(), of_vertices);
  check_size("indices", p.indices()->size(), 3 * of_triangles);
  check_size("materials", p.materials()->size(), of_triangles);
  append(mesh.positions, *p.positions());
  append(mesh.normals, *p.normals());
  append(mesh.uvs, *p.uvs());
  append(mesh.colors, *p.colors());
  append(mesh.indices, *p.indices());
  append(mesh.materials, *p.materials());
}

}  // namespace artu::traces
