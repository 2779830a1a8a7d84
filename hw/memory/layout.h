// The memory image: what the driver lays down and the blocks fetch, to the byte.
//
// Little-endian, every record 64-byte aligned, so that a record of 64 bytes is one cache line.
#pragma once

#include <cstdint>

#include "hw/datapath/ray.h"
#include "hw/unit_config.h"

namespace artu::hw {

using Address = std::uint64_t;

/// Reference to a child: an inner node of either tree, or a leaf's run of triangles.
///   bit 31 leaf, bit 30 dynamic tree;  inner: bits 29-0 node index;  leaf: bits 29-26 count - 1, bits 25-0 first
///   triangle
struct NodeReference {
  static constexpr std::uint32_t leaf_bit = 1u << 31, dynamic_bit = 1u << 30;
  static constexpr std::uint32_t maximum_leaf = 16, maximum_triangles = 1u << 26, maximum_nodes = 1u << 30;
  static constexpr std::uint32_t none = 0xffffffffu;  // an empty tree

  static std::uint32_t inner(std::uint32_t index, bool dynamic) { return index | (dynamic ? dynamic_bit : 0); }
  static std::uint32_t leaf(std::uint32_t first, std::uint32_t count, bool dynamic) {
    return leaf_bit | (dynamic ? dynamic_bit : 0) | (count - 1) << 26 | first;
  }
  static bool is_leaf(std::uint32_t r) { return (r & leaf_bit) != 0; }
  static bool is_dynamic(std::uint32_t r) { return (r & dynamic_bit) != 0; }
  static std::uint32_t index(std::uint32_t r) { return r & 0x3fffffffu; }
  static std::uint32_t first(std::uint32_t r) { return r & 0x03ffffffu; }
  static std::uint32_t count(std::uint32_t r) { return ((r >> 26) & 15) + 1; }
};

/// Bytes of a node of this kind; its address is a multiple of this from the tree's base.
inline std::uint32_t node_bytes(TreeKind kind) { return kind == TreeKind::bvh8 ? 128 : kind == TreeKind::kd ? 16 : 64; }

/// Binary BVH node: both children's boxes and references.
struct alignas(64) NodeRecord {
  Vector lo[2], hi[2];
  std::uint32_t child[2];
  std::uint32_t reserved[2];
};

/// Wide BVH node: the children's boxes as 8-bit steps of a power of two from an origin.  The decoded box
/// (decoded_lo, decoded_hi in hw/datapath/node_visit.h) contains the child; 64 bytes with 4 children, 128 with 8.
template <int Width>
struct alignas(64) WideNodeRecord {
  Vector origin;
  std::uint8_t exponent[3];  // of the step on each axis, biased as in binary32: 1 ... 254
  std::uint8_t count;        // children, 1 ... Width
  std::uint8_t lo[3][Width], hi[3][Width];
  std::uint32_t child[Width];
};

/// kd-tree node; four lie in a line.  A child is `none` where its cell is empty.
struct alignas(16) KdNodeRecord {
  float split;
  std::uint32_t axis;  // 0 ... 2: child 0 is below the plane, child 1 above; `both`: the children share the cell
  std::uint32_t child[2];
  static constexpr std::uint32_t both = 3;  // for leaves with more triangles than a reference can count
};

/// Triangle in leaf order; what the intersection unit reads.  A kd-tree has one for each leaf that refers to it.
struct alignas(64) TriangleRecord {
  Vector a, b, c;
  std::uint32_t primitive;  // global id
  std::uint32_t material;
  std::uint32_t color[3];    // of the vertices: linear R, G, B, A codes
  std::uint32_t attributes;  // index of its AttributeRecord
  std::uint32_t reserved;
};

/// Attributes of a triangle; what the hit-point unit reads.
struct alignas(64) AttributeRecord {
  Vector normal[3];
  float uv[3][2];
  std::uint32_t reserved;
};

enum class TextureWrap : std::uint8_t { repeat, clamp, mirror };

/// Material with its texture's descriptor; two lines.
struct alignas(64) MaterialRecord {
  Vector diffuse, specular, mirror, transmission, emission;
  float ior;
  std::uint32_t specular_log2;
  std::uint32_t tint;
  Address texels;  // 0: no texture
  std::uint32_t width, height;
  TextureWrap wrap_u, wrap_v;
};

/// Texels lie in tiles of 4 x 4, one line each, tiles row by row.
inline Address texel_address(Address base, std::uint32_t width, std::uint32_t x, std::uint32_t y) {
  const std::uint32_t tiles = (width + 3) / 4;
  return base + (static_cast<Address>(y / 4) * tiles + x / 4) * 64 + ((y % 4) * 4 + x % 4) * 4;
}

enum class LightType : std::uint32_t { point, directional, spot };

struct alignas(64) LightRecord {
  Vector position, direction, color;
  float range, cos_inner, cos_outer;
  LightType type;
};

/// Where a context's traversal stack overflows to: a slot of 16 bytes an entry (node, enter, exit).
inline constexpr Address spill_entry_bytes = 16, spill_bytes = 128 * spill_entry_bytes;

/// What a top-down build of this frame's tree comes to: the cost of splitting is that of the very tree.
struct BuildWork {
  std::uint32_t splits;            // inner nodes of the binary tree (of a kd-tree: planes)
  std::uint32_t upper_splits;      // those of more references than fit on chip
  std::uint64_t references;        // summed over the splits: each handles every reference below it
  std::uint64_t upper_references;  // summed over the upper splits
  std::uint32_t upper_levels;      // of the tree, with upper splits
  std::uint32_t lower_references;  // of the subtrees below the upper splits: in a kd-tree more than triangles
};

/// What the control unit reads at the start of a frame.
struct alignas(64) FrameDescriptor {
  std::uint32_t width, height;
  TreeKind static_kind, dynamic_kind;
  std::uint32_t static_root, dynamic_root;  // NodeReference; none = empty
  Vector static_lo, static_hi, dynamic_lo, dynamic_hi;
  Address static_nodes, dynamic_nodes;
  Address static_triangles, dynamic_triangles;
  Address static_attributes, dynamic_attributes;
  Address materials, lights;
  Address frame_buffer;   // 4 bytes a pixel (R, G, B, 255), rows of `pitch` pixels
  Address hit_classes;    // 1 byte a pixel (HitClass), rows of `pitch` pixels
  Address build_input;    // triangles in the mesh's order, a line each, then their attributes, a line each
  Address build_scratch;  // two areas of 16 bytes a triangle record, each a whole number of lines
  Address stack_spills;   // spill_bytes for every context of every core; 0 unless the unit spills
  std::uint32_t pitch;    // pixels, a multiple of 64
  std::uint32_t light_count;
  std::uint32_t dynamic_triangle_count;
  std::uint32_t dynamic_reference_count;  // triangle records: more than triangles in a kd-tree
  std::uint32_t dynamic_node_lines;
  std::uint32_t dynamic_moved;
  std::uint32_t dynamic_refit;  // 1: the nodes are those of an earlier frame, their boxes are made anew
  BuildWork build;
  CameraRegisters camera;
  Vector ambient, sky_nadir, sky_zenith;
};

static_assert(sizeof(WideNodeRecord<4>) == 64 && sizeof(WideNodeRecord<8>) == 128 && sizeof(KdNodeRecord) == 16);
static_assert(sizeof(NodeRecord) == 64 && sizeof(TriangleRecord) == 64 && sizeof(AttributeRecord) == 64);
static_assert(sizeof(MaterialRecord) == 128 && sizeof(LightRecord) == 64);

}  // namespace artu::hw
