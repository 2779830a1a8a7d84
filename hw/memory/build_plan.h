// What the tree builder does for a frame, step by step: how long each step computes and which lines it moves.
//
// With n triangles, R triangle records, N lines of nodes (all in the descriptor), and B = triangles_per_pass: what has
// at most B triangles is split or sorted on chip; the streams in brackets below are there for n > B alone.
//
// sah (BVHs and kd-trees), with the descriptor's BuildWork of the tree that comes out:
//   read        reads n triangles                             n * cycles_per_record
//               [writes n references of 16 bytes: box in 16-bit steps, and number]
//   levels      [a step for each of the upper_levels:         references * cycles_per_triangle / binning_units
//               reads its references, writes them to their    + splits * bins * cycles_per_bin
//               side of the plane while they are binned there]
//   subtrees    [reads the references] reads n triangles,     the same, of all other splits
//               writes N nodes, R triangles
//   attributes  reads n, writes n                             n * cycles_per_record
// morton (BVHs):
//   read        reads n triangles (not with known_box)        n * cycles_per_record
//   codes       reads n triangles [writes n keys]             n * cycles_per_record
//   sort        ceil(3 code_bits / digit_bits) steps:         (n + 2^digit_bits) * cycles_per_record
//               [reads and writes n keys]                     (the digit's counters are summed up first)
//   hierarchy   [reads n keys, writes n - 1 nodes of 8 bytes] (n - 1) * cycles_per_node
//   bounds      [reads those] reads n triangles,              2 (n - 1) * cycles_per_box: two children a node
//               writes N nodes, R triangles
//   attributes  as above
// refit (BVHs), whose nodes stay:
//   bounds      reads N nodes, n triangles, writes both       (n + nodes) * cycles_per_box
//   attributes  as above
// A key is a code and the triangle's number: 8 bytes up to 10 code_bits, 12 above.
//
// Sources.  sah: binning and partitioning from the top, and the sweep of a node's bins, as in the builder of Doyle,
// Fowler and Manzke (A Hardware Unit for Fast SAH-optimised BVH Construction, 2013); that one pass over a level does
// both, for several references at a time (binning_units), is assumed; a kd-tree's references are counted as often as
// they are.  morton: codes, sort and a hierarchy that is emitted as a stream are MergeTree (Viitanen et al. 2017), its
// merge sort replaced by the radix sort of GPU builders, on the tree of Karras (Maximizing Parallelism in the
// Construction of BVHs, 2012).  Figures that these are held against: docs/tree_builder.md.
#pragma once

#include <array>
#include <vector>

#include "hw/memory/layout.h"

namespace artu::hw {

enum class BuildStage : std::uint8_t { read, levels, subtrees, codes, sort, hierarchy, bounds, attributes };
inline constexpr std::size_t build_stages = 8;
/// The builder's counters of their cycles.
inline constexpr std::array<const char*, build_stages> stage_counters{
    "cycles_read", "cycles_levels",    "cycles_subtrees", "cycles_codes",
    "cycles_sort", "cycles_hierarchy", "cycles_bounds",   "cycles_attributes"};

/// Lines from `base` on, read or written.
struct BuildStream {
  Address base;
  std::uint64_t lines;
  bool write;
};

struct BuildStep {
  BuildStage stage;
  std::vector<BuildStream> streams;
  std::uint64_t compute;  // cycles
};

/// At least one triangle.
std::vector<BuildStep> plan_build(const TreeBuilderConfig& config, const FrameDescriptor& frame);

}  // namespace artu::hw
