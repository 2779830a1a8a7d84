// The shading unit: the order of next rays, texels, and throughput.
#include <gtest/gtest.h>

#include "unit/hw/shading_support.h"

namespace artu::hw::test {
namespace {

TEST(Shading, ReflectionIsFollowedToItsEndBeforeRefraction) {
  Shader s;
  s.material().mirror = {0.5f, 0.5f, 0.5f};
  s.material().transmission = {0.5f, 0.5f, 0.5f};
  s.hit_source.push_at(9, 0).push_at(999, 0);  // the reflection ray hits the same glass again
  s.miss_source.push_at(1999, 0).push_at(2999, 0).push_at(3999, 0);
  s.bench.run(5000);
  EXPECT_EQ(s.sent,
            (std::vector<RayKind>{RayKind::reflection, RayKind::reflection, RayKind::refraction, RayKind::refraction}));
  EXPECT_EQ(s.depths, (std::vector<unsigned>{1, 2, 2, 1}));
  const Pipelines& p = s.scene.pipelines;
  EXPECT_EQ(s.rays.cycles[0],
            Shader::shaded + p.texture + p.accumulate + p.light + p.next_ray + 1);  // no light is looked at
  EXPECT_EQ(s.rays.cycles[2], 2000 + Cycle{p.accumulate} + 1);
  EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{4000 + Cycle{p.accumulate} + 1});
}

TEST(Shading, NothingIsFollowedBeyondTheDepth) {
  Shader s;
  s.material().mirror = {1, 1, 1};
  s.scene.registers.shading.max_depth = 0;
  s.hit_source.push_at(9, 0);
  s.bench.run(500);
  EXPECT_TRUE(s.rays.tokens.empty());
  EXPECT_EQ(s.pixels.tokens.size(), 1u);
}

TEST(Shading, TexelsAreFetchedAfterTheMaterial) {
  for (bool at_a_corner : {false, true}) {
    Shader s;
    const Address texels = s.scene.image.allocate(4 * 64);  // moves the records
    s.material().texels = texels;
    s.material().width = s.material().height = 8;  // four tiles: four lines
    // At u = v = 0.5 the sample lies between texels 3 and 4: a texel of each tile.
    s.scene.contexts[0].surface.u = s.scene.contexts[0].surface.v = at_a_corner ? 0.5f : 0.25f;
    s.hit_source.push_at(9, 0);
    s.bench.run(500);
    const std::size_t lines = at_a_corner ? 4 : 1;
    EXPECT_EQ(s.memory.requests.size(), 2 + lines) << "no line twice";
    // The first one is asked for in the cycle in which the material is there.
    EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{Shader::shaded + lines - 1 + 1 + hit_latency + s.last_sum(0) + 1});
    EXPECT_EQ(counter(s.shading, "textured"), 1u);
  }
}

TEST(Shading, ManyHitsAreBoundByTheirTwoLinesEach) {
  Shader s;
  for (Slot slot : slots(32)) s.hit_source.push_at(9, slot);
  s.bench.run(500);
  EXPECT_EQ(s.pixels.cycles, every(Shader::shaded + s.last_sum(0) + 1, 32, 2));
  EXPECT_EQ(s.memory.cycles, every(11, 64));
}

TEST(Shading, MissesAreShadedOneACycle) {
  Shader s;
  for (Slot slot : slots(32)) s.miss_source.push_at(9, slot);
  s.bench.run(500);
  EXPECT_EQ(s.pixels.cycles, every(10 + s.scene.pipelines.accumulate + 1, 32));
}

TEST(Shading, AHitOccupiesTheShaderForACycleALight) {
  Shader s;
  for (int i = 0; i < 5; ++i) s.light({0, 0, -5});
  for (Slot slot : slots(16)) s.hit_source.push_at(9, slot);
  s.bench.run(500);
  EXPECT_EQ(s.pixels.cycles, every(Shader::shaded + s.last_sum(5) + 1, 16, 5));
}

TEST(Shading, WaitsForTheFrameWriter) {
  Shader s;
  s.pixels.open = [](Cycle now) { return now >= 300; };
  for (Slot slot : slots(32)) s.miss_source.push_at(9, slot);
  s.bench.run(500);
  EXPECT_EQ(s.pixels.cycles, every(300, 32));
  EXPECT_GT(s.shading.cycles_in(State::stall_out), 200u);
}

}  // namespace
}  // namespace artu::hw::test
