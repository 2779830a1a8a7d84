// Every parameter of the unit.  The defaults are a mobile unit of RayCore's class at 500 MHz.
#pragma once

#include <array>
#include <cstdint>

#include "hw/dram_config.h"
#include "hw/energy_config.h"
#include "hw/fabric/parameter.h"

namespace artu::hw {

/// Latencies of the arithmetic operators, from which every datapath's pipeline depth follows.
struct OperatorConfig {
  std::uint32_t add = 3, multiply = 3, divide = 12, square_root = 12, compare = 1;
  void visit(ParameterVisitor& v);
};

/// Stored fraction bits of the datapaths' formats (docs/arithmetic.md section 1); 23 is binary32.
struct PrecisionConfig {
  std::uint32_t box = 23, triangle = 23, shading = 23;
  void visit(ParameterVisitor& v);
};

enum class ReplacementPolicy : std::uint8_t { lru, plru, random };

struct CacheConfig {
  std::uint32_t size = 16384;  // bytes
  std::uint32_t ways = 4;
  std::uint32_t hit_latency = 2;  // cycles from request to data
  std::uint32_t mshrs = 8;        // lines that can be outstanding
  std::uint32_t targets = 8;      // requests that can wait for one line
  bool hashed = false;            // sets chosen by a hash of the address
  ReplacementPolicy replacement = ReplacementPolicy::lru;
  std::uint32_t seed = 1;  // of random replacement
  void visit(ParameterVisitor& v);
};

/// What happens to a stack entry that does not fit on chip any more.
enum class StackOverflow : std::uint8_t { refuse, spill, restart };
enum class RayOrder : std::uint8_t { secondary_first, primary_first, first_come };
enum class PixelOrder : std::uint8_t { rows, morton };
enum class Dispatch : std::uint8_t { first_come, tiles };

struct RayCoreConfig {
  std::uint32_t count = 6;
  std::uint32_t contexts = 32;  // pixels in flight, one ray each
  std::uint32_t stack_entries = 64;
  StackOverflow stack_overflow = StackOverflow::refuse;
  std::uint32_t queue_depth = 4;  // between the core's blocks
  std::uint32_t box_testers = 2;  // boxes (or planes) tested in a cycle
  std::uint32_t node_interval = 1, triangle_interval = 1;
  RayOrder ray_order = RayOrder::secondary_first;
  PixelOrder pixel_order = PixelOrder::rows;
  Dispatch dispatch = Dispatch::first_come;
  CacheConfig node_cache{16384, 4, 2, 8, 8};
  CacheConfig triangle_cache{16384, 4, 2, 8, 8};
  CacheConfig texture_cache{8192, 4, 2, 8, 8};
  void visit(ParameterVisitor& v);
};

enum class Magnitude : std::uint8_t { fixed, proportional, progressive };
enum class Passes : std::uint8_t { horizontal_vertical, average };
/// What counts as a hit, against what: of `policy` attention.
enum class Count : std::uint8_t { per_class, merged };
enum class Compare : std::uint8_t { dynamic_vs_static, reference_count };
enum class Metric : std::uint8_t { max_channel, sum, luma };

struct SelectiveConfig {
  bool enabled = true;
  std::uint32_t stride = 2;  // pixels, distance of the sampling pixels
  Passes passes = Passes::horizontal_vertical;
  bool overlap = true;  // a pass begins while the one before goes on elsewhere
  bool overlaps() const { return enabled && overlap; }
  Metric metric = Metric::max_channel;
  std::uint32_t policy = 0;  // its place in hw/selective/policy.h's list; attention is the first
  std::array<std::uint32_t, 4> policy_registers{};
  bool adaptive = true;
  Count count = Count::per_class;
  Compare compare = Compare::dynamic_vs_static;
  std::uint32_t reference_count = 2;
  std::uint32_t reference = 16, minimum = 0, maximum = 255;
  Magnitude magnitude = Magnitude::proportional;
  std::uint32_t step = 2;
  std::array<std::uint32_t, 8> table{1, 2, 4, 7, 11, 16, 22, 29};
  std::uint32_t tile = 16;  // pixels, edge of the tiles in which pixels are visited
  CacheConfig pixel_cache{4096, 4, 2, 8, 8, true};
  void visit(ParameterVisitor& v);
};

enum class TreeKind : std::uint32_t { bvh2, bvh4, bvh8, kd };

/// Acceleration structures, one for each class of geometry.
struct AccelConfig {
  TreeKind static_kind = TreeKind::bvh2, dynamic_kind = TreeKind::bvh2;
  std::uint32_t leaf_size = 4;  // triangles
  void visit(ParameterVisitor& v);
};

struct ShadingConfig {
  std::uint32_t max_depth = 3;
  float min_weight = 0.00390625f;
  void visit(ParameterVisitor& v);
};

struct MemoryConfig {
  std::uint32_t line = 64;                 // bytes
  std::uint32_t interconnect_latency = 4;  // cycles each way between a core and the L2
  std::uint32_t write_combining = 16;      // lines of finished pixels that are held back
  std::uint32_t l2_banks = 4;              // `l2` is divided among them, line by line
  CacheConfig l2{262144, 8, 10, 32, 16, true};
  DramConfig dram;
  void visit(ParameterVisitor& v);
};

enum class BuildAlgorithm : std::uint8_t { sah, morton };

struct TreeBuilderConfig {
  BuildAlgorithm algorithm = BuildAlgorithm::sah;
  bool refit = false;                       // between full builds, only the boxes are made anew
  std::uint32_t refit_interval = 8;         // frames from one full build to the next
  std::uint32_t triangles_per_pass = 1024;  // held on chip: what is no larger needs no traffic
  std::uint32_t cycles_per_record = 1;      // to read and pass on a triangle, its attributes or a key
  std::uint32_t cycles_per_triangle = 4;    // sah: of a binning unit, for each reference at each level
  std::uint32_t binning_units = 1;
  std::uint32_t bins = 16, cycles_per_bin = 1;  // sah: to find the best plane of a node
  std::uint32_t code_bits = 10;                 // morton: for each axis
  bool known_box = false;                       // morton: the grid is the root box, without a pass to find one
  std::uint32_t digit_bits = 8;                 // morton: sorted by in one pass
  std::uint32_t cycles_per_node = 1;            // morton: to emit a node
  std::uint32_t cycles_per_box = 1;             // morton, refit: to enlarge a box by another
  std::uint32_t outstanding = 32;               // memory requests in flight
  bool overlap = false;                         // rays begin while the tree is being built
  void visit(ParameterVisitor& v);
};

/// Work that a frame does not need and that is left out; each changes cycles and counts, and no pixel.
struct SkipConfig {
  bool dynamic_root = true;  // the dynamic tree, of a ray that misses its root box
  bool rebuild = true;       // the dynamic tree's build, where nothing has moved
  bool shadow = true;        // the shadow ray towards a light that can add nothing
  bool texture = true;       // the texel fetch of a material without a texture
  bool any_hit = true;       // what a shadow ray would do behind its first hit
  void visit(ParameterVisitor& v);
};

struct UnitConfig {
  std::uint32_t clock_mhz = 500;
  std::uint32_t watchdog = 1000000;  // cycles without a token moving: dead-lock
  RayCoreConfig core;
  AccelConfig accel;
  PrecisionConfig precision;
  OperatorConfig operators;
  ShadingConfig shading;
  SelectiveConfig selective;
  TreeBuilderConfig tree_builder;
  SkipConfig skip;
  MemoryConfig memory;
  EnergyConfig energy;
  void visit(ParameterVisitor& v);
};

}  // namespace artu::hw
