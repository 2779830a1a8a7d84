// What workers send back (archive.h).  A field that is not named here would be lost on the way: a test compares the
// reports of one process and of several.
#pragma once

#include "sim/compare/frame_compare.h"
#include "sim/compare/full_render.h"
#include "sim/jobs/archive.h"
#include "sim/report/numbers.h"

namespace artu::hw {

template <class A>
void transfer(A& archive, Statistic& s) {
  pass_all(archive, s.block, s.name, s.value, s.unit, s.text);
}

}  // namespace artu::hw

namespace artu::sim {

template <class A>
void transfer(A& archive, Image& image) {
  pass_all(archive, image.width, image.height, image.rgb);
}

template <class A>
void transfer(A& archive, FullRender& full) {
  pass_all(archive, full.image, full.classes);
}

template <class A>
void transfer(A& archive, Estimate& e) {
  pass_all(archive, e.block, e.name, e.unit, e.value, e.low, e.high);
}

template <class A>
void transfer(A& archive, Totals& t) {
  pass(archive, t.fidelity);
  for (std::uint64_t* count :
       {&t.frames, &t.cycles, &t.static_triangles, &t.dynamic_triangles, &t.sampled, &t.interpolated, &t.traced,
        &t.miss, &t.static_hits, &t.dynamic_hits, &t.rays_primary, &t.rays_shadow, &t.rays_reflection,
        &t.rays_refraction, &t.node_visits, &t.triangle_tests, &t.dram_read_bytes, &t.dram_write_bytes}) {
    pass(archive, *count);
  }
  pass_all(archive, t.dynamic_tree, t.simulation_seconds, t.statistics, t.estimates, t.memory);
}

/// The kinds of rays are literals of the program, which all its processes have at the same place.
template <class A>
void transfer(A& archive, CheckResult& c) {
  pass_all(archive, c.pixels, c.differing_pixels, c.differing_fields, c.first, c.rays, c.golden_seconds,
           c.simulation_seconds);
}

}  // namespace artu::sim
