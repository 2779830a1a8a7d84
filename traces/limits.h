// Sizes that a trace may have.  They bound what a hostile file can make a reader allocate; docs/traces.md
// states them for other readers and writers.
#pragma once

#include <cstddef>
#include <cstdint>

namespace artu::traces {

inline constexpr std::uint32_t format_version = 1;

inline constexpr std::uint32_t max_side = 16384;          // of a picture or a texture
inline constexpr std::uint32_t max_elements = 1u << 28;   // vertices, and triangles, of one mesh
inline constexpr std::uint32_t part_elements = 1u << 20;  // of each in one MeshPart chunk
inline constexpr std::uint32_t max_materials = 65536;
inline constexpr std::uint32_t max_textures = 65536;
inline constexpr std::uint32_t max_lights = 64;
inline constexpr std::size_t max_text = 4096;  // bytes of a name

// Decompressed bytes of a chunk, by kind: the content at its largest, and slack for the encoding.
inline constexpr std::uint64_t max_header_bytes = 65536;
inline constexpr std::uint64_t max_materials_bytes = 512ull << 20;
inline constexpr std::uint64_t max_texture_bytes = std::uint64_t{max_side} * max_side * 4 + 65536;
inline constexpr std::uint64_t max_part_bytes = std::uint64_t{part_elements} * 52 + 65536;
inline constexpr std::uint64_t max_frame_bytes = 65536;
// Of all chunks of the scene, and of all chunks of one frame.
inline constexpr std::uint64_t max_total_bytes = 16ull << 30;
inline constexpr int max_window_log = 27;  // zstd's memory, as its own command line limits it

/// Chunks that hold a mesh of this size: each but the last is full of one or the other.
inline constexpr std::uint32_t part_count(std::uint64_t vertices, std::uint64_t triangles) {
  const std::uint64_t most = vertices > triangles ? vertices : triangles;
  return static_cast<std::uint32_t>((most + part_elements - 1) / part_elements);
}

}  // namespace artu::traces
