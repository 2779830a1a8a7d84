// Verified FlatBuffers to scene and frame.  Values are checked by validate(); here only what is needed
// to copy safely: kinds, numbers and lengths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "traces/frame.h"
#include "traces/wire.h"
#include "traces/zstd_frame.h"

namespace artu::traces {

/// How many chunks and elements a header or a frame announces.
struct HeaderCounts {
  std::uint32_t materials = 0, textures = 0, vertices = 0, triangles = 0;
};
struct FrameCounts {
  std::uint32_t vertices = 0, triangles = 0;
};

/// A decompressed chunk, checked: FlatBuffer structure, version and kind.
class Chunk {
 public:
  Chunk(Bytes bytes, fb::Body kind, std::string where);

  void header(Scene& scene, HeaderCounts& counts) const;
  void materials(Scene& scene, std::uint32_t count) const;
  void texture(Scene& scene) const;
  void frame(Frame& frame, FrameCounts& counts) const;
  /// Appends part `number` of a mesh of `vertices` and `triangles`.
  void part(Mesh& mesh, std::uint32_t number, std::uint32_t vertices, std::uint32_t triangles) const;

 private:
  [[noreturn]] void fail(const std::string& what) const;
  void check_count(const char* what, std::uint64_t count, std::uint64_t most) const;
  void check_size(const char* array, std::size_t size, std::size_t expected) const;
  std::string text(const char* what, const flatbuffers::String& text) const;

  Bytes bytes_;
  const fb::Chunk* root_ = nullptr;
  std::string where_;
};

}  // namespace artu::traces
