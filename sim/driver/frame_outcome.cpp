#include "sim/driver/frame_outcome.h"

namespace artu::sim {
namespace {

std::uint64_t sum(const hw::Statistics& statistics, const std::string& name) {
  std::uint64_t total = 0;
  for (const hw::Statistic& s : statistics) {
    if (s.name == name) total += s.value;
  }
  return total;
}

}  // namespace

FrameOutcome outcome_of(const traces::Scene& scene, const traces::Frame& frame, hw::Statistics statistics) {
  FrameOutcome outcome;
  outcome.index = frame.index;
  outcome.width = scene.width;
  outcome.height = scene.height;
  outcome.static_triangles = scene.static_geometry.triangle_count();
  outcome.dynamic_triangles = frame.dynamic.triangle_count();
  outcome.rays_primary = sum(statistics, "primary_rays");
  outcome.rays_shadow = sum(statistics, "shadow_rays");
  outcome.rays_reflection = sum(statistics, "reflection_rays");
  outcome.rays_refraction = sum(statistics, "refraction_rays");
  outcome.node_visits = sum(statistics, "node_visits");
  outcome.triangle_tests = sum(statistics, "triangle_tests");
  outcome.dram_read_bytes = sum(statistics, "read_bytes");
  outcome.dram_write_bytes = sum(statistics, "write_bytes");
  outcome.statistics = std::move(statistics);
  return outcome;
}

}  // namespace artu::sim
