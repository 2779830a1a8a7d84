#include "hw/functional/counts.h"

namespace artu::hw {

void FunctionalCounts::report(Statistics& out) const {
  static const char* const names[ray_kinds] = {"primary_rays", "shadow_rays", "reflection_rays", "refraction_rays"};
  for (std::size_t kind = 0; kind < ray_kinds; ++kind) {
    out.push_back({"core.ray_generator", names[kind], rays[kind], "rays", "rays of this kind that were set up"});
  }
  const auto add = [&out](const char* block, const char* name, std::uint64_t value, const char* unit,
                          const char* text) {
    out.push_back({block, name, value, unit, text});
  };
  add("core.traversal", "node_visits", nodes, "", "inner nodes fetched and tested");
  add("core.traversal", "box_tests", boxes, "", "boxes tested, root boxes included");
  add("core.traversal", "leaves", leaves, "", "leaves given to intersection");
  add("core.traversal", "stack_pushes", pushes, "", "entries put on traversal stacks");
  add("core.traversal", "dropped", dropped, "", "stack entries that began behind the best hit");
  add("core.traversal", "spilled_lines", spilled_lines, "lines", "of stack entries written to memory");
  add("core.traversal", "refilled_lines", refilled_lines, "lines", "of stack entries read back");
  add("core.traversal", "restarts", restarts, "", "walks from the roots again, for a forgotten stack entry");
  add("core.traversal", "dynamic_skipped", dynamic_skipped, "rays", "rays that missed the dynamic tree's root box");
  add("core.intersection", "triangle_tests", triangles, "", "triangles tested, of a shadow ray up to its first hit");
  add("core.intersection", "left_out", left_out, "", "triangles in a leaf behind a shadow ray's first hit");
  add("core.hit_point", "hit_points", hit_points, "", "hits whose surface was computed");
  add("core.shading", "hits_shaded", hit_points, "", "hits shaded");
  add("core.shading", "sky", sky, "", "rays that missed and got the sky");
  add("core.shading", "lights", lights, "", "lights looked at");
  add("core.shading", "lights_skipped", lights_skipped, "", "lights that could add nothing: no shadow ray");
  add("core.shading", "textured", textured, "", "hits with a texture");
  add("core.shading", "textures_skipped", textures_skipped, "", "hits without one: no texel fetched");
  add("core.shading", "pixels", sampled + traced, "pixels", "pixels finished");
  add("first_rendering_unit", "pixels", sampled, "pixels", "sampling pixels");
  add("candidate_pixel_extractor", "candidates", candidates, "pixels", "candidate pixels handed on");
  add("collision_counter", "static_hits", static_neighbours, "", "static neighbours counted");
  add("collision_counter", "dynamic_hits", dynamic_neighbours, "", "dynamic neighbours counted");
  add("threshold_adjuster", "lowered", lowered, "pixels", "candidates whose threshold is below the reference");
  add("threshold_adjuster", "raised", raised, "pixels", "candidates whose threshold is above the reference");
  add("render_executor", "interpolated", interpolated, "pixels", "candidates interpolated");
  add("render_executor", "traced", traced, "pixels", "candidates ray traced");
  add("render_executor", "differences", differences, "", "colour differences taken, of a centre two");
  add("frame_writer", "pixels", sampled + candidates, "pixels", "pixels written");
}

}  // namespace artu::hw
