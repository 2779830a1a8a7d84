// The datapath's steps, each as often as a ray core does it.
#include <benchmark/benchmark.h>

#include <random>

#include "hw/datapath/hit_tests.h"
#include "hw/datapath/selective.h"
#include "hw/datapath/shading.h"
#include "hw/memory/image.h"
#include "sim/bench/terrain.h"
#include "sim/driver/image_builder.h"

namespace artu {
namespace {

/// Rays from above into the unit cube.
std::vector<hw::Ray> rays(const hw::HitTests& tests) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> at(-1, 1);
  std::vector<hw::Ray> out(1024);
  for (hw::Ray& ray : out) {
    ray.origin = {at(random), 2, at(random)};
    ray.direction = {at(random) * 0.5f, -1, at(random) * 0.5f};
    ray.tmax = hw::two_pow_100;
    tests.set_up(ray);
  }
  return out;
}

void BoxTest(benchmark::State& state) {
  const hw::HitTests tests;
  const auto all = rays(tests);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(tests.box(all[++i % all.size()], {-0.5f, -1, -0.5f}, {0.5f, 0, 0.5f}));
}
BENCHMARK(BoxTest);

void TriangleTest(benchmark::State& state) {
  const hw::HitTests tests;
  const auto all = rays(tests);
  std::size_t i = 0;
  hw::TriangleHit hit;
  for (auto _ : state) {
    benchmark::DoNotOptimize(tests.triangle(all[++i % all.size()], {-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, hit));
  }
}
BENCHMARK(TriangleTest);

/// The root of a terrain's tree.
void NodeVisit(benchmark::State& state, hw::TreeKind kind) {
  const traces::Scene scene = sim::terrain(64, 16, 16);
  hw::UnitConfig unit;
  unit.accel.static_kind = unit.accel.dynamic_kind = kind;
  hw::MemoryImage image;
  sim::ImageBuilder builder(scene, unit, {}, image);
  const auto& frame = image.at<hw::FrameDescriptor>(builder.add(sim::terrain_frame(16, 16)));
  const hw::HitTests tests;
  const auto all = rays(tests);
  std::size_t i = 0;
  hw::Step root{frame.static_root, 0, hw::two_pow_100};
  for (auto _ : state) {
    hw::Steps steps;
    tests.node(kind, &image.at<std::uint8_t>(frame.static_nodes), all[++i % all.size()], root, hw::two_pow_100, 0,
               steps);
    benchmark::DoNotOptimize(steps);
  }
}
BENCHMARK_CAPTURE(NodeVisit, bvh2, hw::TreeKind::bvh2);
BENCHMARK_CAPTURE(NodeVisit, bvh4, hw::TreeKind::bvh4);
BENCHMARK_CAPTURE(NodeVisit, bvh8, hw::TreeKind::bvh8);
BENCHMARK_CAPTURE(NodeVisit, kd, hw::TreeKind::kd);

/// A hit's material, one light, and its next rays.
void Shading(benchmark::State& state, int bits) {
  const hw::ShadingSteps& steps = hw::shading_steps(bits);
  hw::ShadingConstants constants;
  constants.ambient = {0.1f, 0.1f, 0.1f};
  constants.min_weight = 0.004f;
  hw::Surface surface{};
  surface.geometric_normal = surface.shading_normal = {0, 1, 0};
  surface.color = {1, 0.5f, 0.25f};
  surface.front = true;
  hw::MaterialRecord material{};
  material.diffuse = {0.5f, 0.5f, 0.5f};
  material.specular = material.mirror = {0.3f, 0.3f, 0.3f};
  material.specular_log2 = 5;
  hw::LightRecord light{};
  light.position = {1, 3, 1};
  light.color = {5, 5, 5};
  light.range = 100;
  light.type = hw::LightType::point;
  for (auto _ : state) {
    hw::ShadedPoint point;
    benchmark::DoNotOptimize(
        steps.begin_shading(constants, surface, material, {1, 1, 1}, {0.6f, -0.8f, 0}, {1, 1, 1}, point));
    hw::ShadowRay shadow;
    benchmark::DoNotOptimize(steps.light_contribution(point, light, shadow));
    benchmark::DoNotOptimize(steps.next_rays(constants, point));
  }
}
BENCHMARK_CAPTURE(Shading, 23, 23);
BENCHMARK_CAPTURE(Shading, 12, 12);

void Interpolate(benchmark::State& state) {
  hw::Pairs pairs;
  pairs.count = 2;
  pairs.color = {{{{{10, 20, 30}, {200, 100, 50}}}, {{{12, 24, 48}, {100, 100, 100}}}}};
  for (auto _ : state) {
    benchmark::DoNotOptimize(pairs);
    benchmark::DoNotOptimize(hw::color_difference(hw::Metric::max_channel, pairs));
    benchmark::DoNotOptimize(hw::interpolate(pairs));
  }
}
BENCHMARK(Interpolate);

}  // namespace
}  // namespace artu
