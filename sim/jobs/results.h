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
  pass(archive, s.block);
  pass(archive, s.name);
  pass(archive, s.value);
  pass(archive, s.unit);
  pass(archive, s.text);
}

}  // namespace artu::hw

namespace artu::sim {

template <class A>
void transfer(A& archive, Image& image) {
  pass(archive, image.width);
  pass(archive, image.height);
  pass(archive, image.rgb);
}

template <class A>
void transfer(A& archive, FullRender& full) {
  pass(archive, full.image);
  pass(archive, full.classes);
}

template <class A>
void transfer(A& archive, Estimate& e) {
  pass(archive, e.block);
  pass(archive, e.name);
  pass(archive, e.unit);
  pass(archive, e.value);
  pass(archive, e.low);
  pass(archive, e.high);
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
  pass(archive, t.dynamic_tree);
  pass(archive, t.simulation_seconds);
  pass(archive, t.statistics);
  pass(archive, t.estimates);
  pass(archive, t.memory);
}

/// The kinds of rays are literals of the program, which all its processes have at the same place.
template <class A>
void transfer(A& archive, CheckResult& c) {
  pass(archive, c.pixels);
  pass(archive, c.differing_pixels);
  pass(archive, c.differing_fields);
  pass(archive, c.first);
  pass(archive, c.rays);
  pass(archive, c.golden_seconds);
  pass(archive, c.simulation_seconds);
}

}  // namespace artu::sim
