#include "hw/unit_config.h"

#include "hw/selective/policy.h"

namespace artu::hw {

void OperatorConfig::visit(ParameterVisitor& v) {
  v.integer("add", add, {1, 64}, "cycles", "latency of an addition or subtraction");
  v.integer("multiply", multiply, {1, 64}, "cycles", "latency of a multiplication");
  v.integer("divide", divide, {1, 64}, "cycles", "latency of a division");
  v.integer("square_root", square_root, {1, 64}, "cycles", "latency of a square root");
  v.integer("compare", compare, {1, 64}, "cycles", "latency of a comparison, minimum or maximum");
}

void PrecisionConfig::visit(ParameterVisitor& v) {
  v.integer("box", box, {7, 23}, "bits", "stored fraction bits of box and plane tests; 23 is binary32");
  v.integer("triangle", triangle, {7, 23}, "bits", "stored fraction bits of triangle tests; 23 is binary32");
  v.integer("shading", shading, {7, 23}, "bits", "stored fraction bits of texture filter, light and colour");
}

void CacheConfig::visit(ParameterVisitor& v) {
  v.integer("size", size, {256, 1u << 26, true}, "bytes", "capacity");
  v.integer("ways", ways, {1, 64, true}, "", "associativity; at most size / line");
  v.integer("hit_latency", hit_latency, {1, 1000}, "cycles", "from a request's arrival to its data, on a hit");
  v.integer("mshrs", mshrs, {1, 1024}, "", "lines that can be outstanding at a time");
  v.flag("hashed", hashed, "choose the set by a hash of the address, so that rows of a picture do not share sets");
  v.choice("replacement", replacement, {"lru", "plru", "random"},
           "which line of a full set goes: the least recently used, nearly that (a tree of bits), or any");
  v.integer("seed", seed, {0, 0xffffffffu}, "", "of random replacement");
  v.integer("targets", targets, {1, 1024}, "", "requests that can wait for one outstanding line");
}

namespace {
void visit_cache(ParameterVisitor& v, const char* name, const char* text, CacheConfig& cache) {
  v.enter(name, text);
  cache.visit(v);
  v.leave();
}
}  // namespace

void RayCoreConfig::visit(ParameterVisitor& v) {
  v.integer("count", count, {1, 64}, "", "number of ray cores");
  v.integer("contexts", contexts, {1, 256}, "", "pixels in flight in a core, each with one ray at a time");
  v.integer("stack_entries", stack_entries, {1, 128}, "", "traversal stack of a ray, on chip");
  v.choice("stack_overflow", stack_overflow, {"refuse", "spill", "restart"},
           "a tree that needs more entries is refused; or the oldest go to memory; or they are forgotten and a restart "
           "trail finds the way from the roots again");
  v.integer("queue_depth", queue_depth, {1, 256}, "", "entries of the queues between a core's blocks");
  v.integer("box_testers", box_testers, {1, 8}, "", "boxes (of a kd-tree: planes) that a core tests in a cycle");
  v.integer("node_interval", node_interval, {1, 64}, "cycles", "initiation interval of the box testers, a node");
  v.integer("triangle_interval", triangle_interval, {1, 64}, "cycles", "initiation interval of the triangle tester");
  v.choice("ray_order", ray_order, {"secondary-first", "primary-first", "first-come"},
           "which rays are set up and begin their traversal first");
  v.choice("pixel_order", pixel_order, {"rows", "morton"},
           "of the first pass, within a tile: row by row, or along a Morton curve");
  v.choice("dispatch", dispatch, {"first-come", "tiles"},
           "pixels go to any core with room in turn, or all of a tile to the same core");
  visit_cache(v, "node_cache", "tree nodes, one a core", node_cache);
  visit_cache(v, "triangle_cache", "triangles and their attributes, one a core", triangle_cache);
  visit_cache(v, "texture_cache", "materials and texels, one a core", texture_cache);
}

void AccelConfig::visit(ParameterVisitor& v) {
  v.integer("leaf_size", leaf_size, {1, 16}, "triangles", "largest leaf, of any kind of tree");
  const auto kind = [&v](const char* group, const char* text, TreeKind& value) {
    v.enter(group, text);
    v.choice("kind", value, {"bvh2", "bvh4", "bvh8", "kd"},
             "binary BVH, 4- or 8-wide BVH with 8-bit child boxes, or kd-tree");
    v.leave();
  };
  kind("static", "tree of the static geometry", static_kind);
  kind("dynamic", "tree of the dynamic geometry", dynamic_kind);
}

void ShadingConfig::visit(ParameterVisitor& v) {
  v.integer("max_depth", max_depth, {0, 16}, "", "bounces of reflection and refraction rays; 0 = none");
  v.real("min_weight", min_weight, {0.0, 1.0}, "", "smallest weight of a reflection or refraction ray that is traced");
}

void SelectiveConfig::visit(ParameterVisitor& v) {
  v.flag("enabled", enabled, "selective rendering; false traces every pixel");
  v.integer("stride", stride, {2, 8, true}, "pixels", "distance of the sampling pixels; at most `tile`");
  v.choice("passes", passes, {"horizontal-vertical", "average"},
           "what lies amid four samples is compared with the pixels above and below, or with all four neighbours");
  v.flag("overlap", overlap,
         "a pass begins where all that it looks at is finished, while the one before goes on elsewhere");
  v.choice("metric", metric, {"max-channel", "sum", "luma"},
           "difference of two colours: of the channel that differs most, of all three, or of the brightness");
  v.choice("policy", policy, policy_names(), "what sets a candidate's threshold");
  v.table("policy_registers", policy_registers, {0, 255}, "", "for policies without parameters of their own");
  v.flag("adaptive", adaptive, "attention: the threshold follows the hits around a pixel; false keeps the reference");
  v.choice("count", count, {"per-class", "merged"},
           "attention: dynamic hits count, or static ones as well, which goes with compare = reference-count alone");
  v.choice("compare", compare, {"dynamic-vs-static", "reference-count"},
           "attention: dynamic hits are compared with static ones, or the count with reference_count");
  v.integer("reference_count", reference_count, {0, 8}, "hits", "attention: the count that leaves the threshold alone");
  v.integer("reference", reference, {0, 255}, "codes", "reference threshold, a difference of 8-bit colour codes");
  v.integer("minimum", minimum, {0, 255}, "codes", "smallest threshold after adjustment");
  v.integer("maximum", maximum, {0, 255}, "codes", "largest threshold after adjustment");
  v.choice("magnitude", magnitude, {"fixed", "proportional", "progressive"}, "attention: size of the threshold's move");
  v.integer("step", step, {0, 255}, "codes",
            "attention: the move, or with proportional the move for each hit of difference");
  v.table("table", table, {0, 255}, "codes", "attention: the move for a difference of 1 ... 8 hits, with progressive");
  v.integer("tile", tile, {4, 256, true}, "pixels", "edge of the tiles in which pixels are visited");
  visit_cache(v, "pixel_cache", "frame buffer lines read by the candidate-pixel extractor", pixel_cache);
}

void TreeBuilderConfig::visit(ParameterVisitor& v) {
  v.choice("algorithm", algorithm, {"sah", "morton"},
           "binned surface-area heuristic, or sorted Morton codes (a BVH alone); the tree is built by the same");
  v.flag("refit", refit, "keep a BVH's nodes between full builds and only make their boxes anew");
  v.integer("refit_interval", refit_interval, {1, 1u << 20}, "frames", "from one full build to the next, with refit");
  v.integer("triangles_per_pass", triangles_per_pass, {16, 1u << 20, true}, "triangles",
            "what is no larger is split or sorted on chip, without memory traffic");
  v.integer("cycles_per_record", cycles_per_record, {1, 1000}, "cycles",
            "to read and pass on a triangle, its attributes, or a key of a sorting pass");
  v.integer("cycles_per_triangle", cycles_per_triangle, {1, 1000}, "cycles",
            "sah: to partition and bin a triangle at a level of the tree, in one binning unit");
  v.integer("binning_units", binning_units, {1, 64}, "", "sah: triangles that are binned at a time");
  v.integer("bins", bins, {2, 256, true}, "", "sah: bins that are swept for each node, the axes side by side");
  v.integer("cycles_per_bin", cycles_per_bin, {1, 1000}, "cycles", "sah: for each bin of the sweep");
  v.integer("code_bits", code_bits, {4, 21}, "bits", "morton: of a code, for each axis; above 10 keys are wider");
  v.flag("known_box", known_box,
         "morton: the grid is the root box, as the driver gives it; false finds the box of all centres in a pass");
  v.integer("digit_bits", digit_bits, {1, 16}, "bits", "morton: digit of the radix sort, one pass each");
  v.integer("cycles_per_node", cycles_per_node, {1, 1000}, "cycles", "morton: to emit a node of the hierarchy");
  v.integer("cycles_per_box", cycles_per_box, {1, 1000}, "cycles",
            "morton, refit: to enlarge a node's box by a triangle's or a child's");
  v.integer("outstanding", outstanding, {1, 256}, "", "memory requests in flight");
  v.flag("overlap", overlap,
         "the first pass begins with the build: rays walk the static tree, and wait where they need the dynamic one");
}

void SkipConfig::visit(ParameterVisitor& v) {
  v.flag("dynamic_root", dynamic_root, "a ray that misses the dynamic tree's root box does not enter that tree");
  v.flag("rebuild", rebuild, "the dynamic tree is not built where nothing has moved since the frame before");
  v.flag("shadow", shadow, "no shadow ray towards a light that cannot add anything");
  v.flag("texture", texture, "no texel is fetched for a material without a texture");
  v.flag("any_hit", any_hit, "a shadow ray ends at its first hit; false looks for the nearest one");
}

void MemoryConfig::visit(ParameterVisitor& v) {
  v.integer("line", line, {64, 64, true}, "bytes", "cache line");
  v.integer("interconnect_latency", interconnect_latency, {1, 1000}, "cycles", "between a core and the L2, each way");
  v.integer("write_combining", write_combining, {2, 1024}, "lines", "of finished pixels, held back to be filled up");
  v.integer("l2_banks", l2_banks, {1, 16, true}, "",
            "banks of the L2, one request a cycle each; size and MSHRs are divided among them");
  visit_cache(v, "l2", "second-level cache, shared", l2);
  v.enter("dram", "DRAM channels and their controllers");
  dram.visit(v);
  v.leave();
}

void UnitConfig::visit(ParameterVisitor& v) {
  v.enter("unit", "the unit as a whole");
  v.integer("clock_mhz", clock_mhz, {1, 10000}, "MHz", "clock");
  v.integer("watchdog", watchdog, {1000, 4000000000u}, "cycles",
            "without a token moving and without a busy block: dead-lock, exit code 3");
  v.leave();
  v.enter("core", "ray cores");
  core.visit(v);
  v.leave();
  v.enter("accel", "acceleration structures");
  accel.visit(v);
  v.leave();
  v.enter("precision", "formats of the datapaths, with 8 exponent bits");
  precision.visit(v);
  v.leave();
  v.enter("operators", "latencies of the arithmetic operators");
  operators.visit(v);
  v.leave();
  v.enter("shading", "shading and next-ray set-up");
  shading.visit(v);
  v.leave();
  v.enter("selective", "selective rendering");
  selective.visit(v);
  v.leave();
  v.enter("tree_builder", "builder of the dynamic tree");
  tree_builder.visit(v);
  v.leave();
  v.enter("skip", "work that is left out where a frame does not need it");
  skip.visit(v);
  v.leave();
  v.enter("memory", "shared memory system");
  memory.visit(v);
  v.leave();
  v.enter("energy", "energy of events, for the reports");
  energy.visit(v);
  v.leave();
}

}  // namespace artu::hw
