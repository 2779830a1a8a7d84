#include <algorithm>
#include <array>
#include <vector>

#include "traces/error.h"
#include "traces/file.h"
#include "traces/limits.h"
#include "traces/trace.h"
#include "traces/unpack.h"
#include "traces/validate.h"
#include "traces/zstd_frame.h"

namespace artu::traces {
namespace {

std::uint64_t largest(fb::Body kind) {
  switch (kind) {
    case fb::Body_Header:
      return max_header_bytes;
    case fb::Body_Materials:
      return max_materials_bytes;
    case fb::Body_Texture:
      return max_texture_bytes;
    case fb::Body_StaticPart:
    case fb::Body_DynamicPart:
      return max_part_bytes;
    default:
      return max_frame_bytes;
  }
}

std::uint64_t content_bytes(const std::vector<ZstdFrame>& chunks, std::size_t first) {
  std::uint64_t sum = 0;
  for (std::size_t i = first; i < chunks.size(); ++i) sum += chunks[i].content_size;
  return sum;
}

}  // namespace

struct Reader::Impl {
  explicit Impl(const std::string& path) : file(path) {
    if (file.size() == 0) throw InputError(path, "is empty; a trace begins with a zstd frame");
    read_scene();
    for (std::uint32_t i = 0; i < scene.frame_count; ++i) find_frame(i);
    if (end != file.size()) {
      fail_at(chunks.size(), end,
              std::to_string(file.size() - end) + " bytes follow the last of " + std::to_string(scene.frame_count) +
                  " frames; the file must end here");
    }
  }

  Frame frame(std::uint32_t position) const {
    if (position >= frames.size()) {
      throw InputError(file.path(), "frame " + std::to_string(position) + " does not exist; the last one is " +
                                        std::to_string(frames.size() - 1));
    }
    Frame frame;
    const std::size_t first = frames[position].chunk;
    FrameCounts counts;
    chunk(first, fb::Body_Frame).frame(frame, counts);
    read_mesh(frame.dynamic, fb::Body_DynamicPart, first + 1, frames[position].counts.vertices,
              frames[position].counts.triangles);
    validate(scene, frame, where(first, chunks[first].offset) + ": frame " + std::to_string(position));
    return frame;
  }

  std::string where(std::size_t number, std::uint64_t offset) const {
    return file.path() + ": chunk " + std::to_string(number) + " (at byte " + std::to_string(offset) + ")";
  }

  [[noreturn]] void fail_at(std::size_t number, std::uint64_t offset, const std::string& what) const {
    throw InputError(where(number, offset), what);
  }

  /// Finds the next chunk, which must be of this kind.
  void find(fb::Body kind, const std::string& what) {
    if (end == file.size()) fail_at(chunks.size(), end, "the file ends here; " + what + " must follow. Is it cut off?");
    const ZstdFrame found = scan_frame(file, end, where(chunks.size(), end));
    if (found.content_size > largest(kind)) {
      fail_at(chunks.size(), end,
              "declares " + std::to_string(found.content_size) + " bytes of content; " + what + " has at most " +
                  std::to_string(largest(kind)));
    }
    chunks.push_back(found);
    end += found.size;
  }

  void find_parts(fb::Body kind, std::uint32_t vertices, std::uint32_t triangles, const std::string& what) {
    const std::uint32_t parts = part_count(vertices, triangles);
    for (std::uint32_t i = 0; i < parts; ++i) {
      find(kind, "part " + std::to_string(i) + " (of " + std::to_string(parts) + ") of " + what);
    }
  }

  Chunk chunk(std::size_t number, fb::Body kind) const {
    const std::string at = where(number, chunks[number].offset);
    return Chunk(decompress(file, chunks[number], at), kind, at);
  }

  void check_total(std::size_t first) const {
    const std::uint64_t total = content_bytes(chunks, first);
    if (total > max_total_bytes) {
      fail_at(first, chunks[first].offset,
              "and what belongs to it have " + std::to_string(total) +
                  " bytes of content; this program reads at most " + std::to_string(max_total_bytes));
    }
  }

  void read_mesh(Mesh& mesh, fb::Body kind, std::size_t first, std::uint32_t vertices, std::uint32_t triangles) const {
    const std::uint32_t parts = part_count(vertices, triangles);
    std::uint64_t bytes = 0;
    for (std::uint32_t i = 0; i < parts; ++i) bytes += chunks[first + i].content_size;
    // Only what the chunks can hold is worth a reservation; a lie is found with the first part.
    if (bytes >= std::uint64_t{vertices} * 36 + std::uint64_t{triangles} * 16) {
      mesh.positions.reserve(vertices);
      mesh.normals.reserve(vertices);
      mesh.uvs.reserve(vertices);
      mesh.colors.reserve(vertices);
      mesh.indices.reserve(std::size_t{triangles} * 3);
      mesh.materials.reserve(triangles);
    }
    for (std::uint32_t i = 0; i < parts; ++i) chunk(first + i, kind).part(mesh, i, vertices, triangles);
  }

  void read_scene() {
    find(fb::Body_Header, "a header");
    HeaderCounts counts;
    chunk(0, fb::Body_Header).header(scene, counts);
    if (scene.frame_count == 0) fail_at(0, 0, "frame_count is 0; a trace has at least one frame");
    find(fb::Body_Materials, "the materials");
    for (std::uint32_t i = 0; i < counts.textures; ++i) {
      find(fb::Body_Texture, "texture " + std::to_string(i) + " (of " + std::to_string(counts.textures) + ")");
    }
    find_parts(fb::Body_StaticPart, counts.vertices, counts.triangles, "the static geometry");
    check_total(0);

    chunk(1, fb::Body_Materials).materials(scene, counts.materials);
    for (std::uint32_t i = 0; i < counts.textures; ++i) chunk(2 + i, fb::Body_Texture).texture(scene);
    read_mesh(scene.static_geometry, fb::Body_StaticPart, 2 + counts.textures, counts.vertices, counts.triangles);
    validate(scene, file.path());
  }

  void find_frame(std::uint32_t position) {
    const std::string name = "frame " + std::to_string(position);
    const std::size_t first = chunks.size();
    find(fb::Body_Frame, name + " (of " + std::to_string(scene.frame_count) + ")");
    Frame frame;
    FrameCounts counts;
    chunk(first, fb::Body_Frame).frame(frame, counts);
    find_parts(fb::Body_DynamicPart, counts.vertices, counts.triangles, name + "'s dynamic geometry");
    check_total(first);
    if (!frame.dynamic_moved && position > 0 && !same_geometry(frames.back(), counts, first)) {
      fail_at(first, chunks[first].offset,
              name + ": dynamic_moved is false, but the dynamic geometry differs from the preceding frame's");
    }
    frames.push_back({first, counts});
  }

  struct FrameIndex {
    std::size_t chunk;
    FrameCounts counts;
  };

  /// By the checksums: equal geometry has equal chunks.
  bool same_geometry(const FrameIndex& before, const FrameCounts& counts, std::size_t first) const {
    if (before.counts.vertices != counts.vertices || before.counts.triangles != counts.triangles) return false;
    return std::equal(chunks.begin() + first + 1, chunks.end(), chunks.begin() + before.chunk + 1,
                      [](const ZstdFrame& a, const ZstdFrame& b) {
                        return a.checksum == b.checksum && a.content_size == b.content_size;
                      });
  }

  InputFile file;
  std::vector<ZstdFrame> chunks;
  std::uint64_t end = 0;  // of the last chunk
  std::vector<FrameIndex> frames;
  Scene scene;
};

Reader::Reader(const std::string& path) : impl_(std::make_unique<Impl>(path)) {}
Reader::~Reader() = default;
const Scene& Reader::scene() const { return impl_->scene; }
Frame Reader::frame(std::uint32_t position) const { return impl_->frame(position); }

bool is_trace(const std::string& path) {
  try {
    constexpr std::array<std::uint8_t, 4> magic{0x28, 0xB5, 0x2F, 0xFD};
    std::array<std::uint8_t, 4> first{};
    InputFile(path).read(0, first.data(), first.size());
    return first == magic;
  } catch (const InputError&) {
    return false;  // whoever opens the file next says why
  }
}

}  // namespace artu::traces
