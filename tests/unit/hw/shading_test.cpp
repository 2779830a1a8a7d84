// The shading unit: what a hit and a miss cost, and the light loop.
#include <gtest/gtest.h>

#include "hw/datapath/color.h"
#include "unit/hw/shading_support.h"

namespace artu::hw::test {
namespace {

TEST(Shading, AMaterialIsTwoLines) {
  Shader s;
  s.hit_source.push_at(9, 0);
  s.bench.run(300);
  const Address material = s.scene.registers.descriptor.materials;
  EXPECT_EQ(s.memory.lines(), (std::vector<Address>{material, material + 64}));
  EXPECT_EQ(s.memory.cycles, (std::vector<Cycle>{11, 12}));
}

TEST(Shading, AMissGetsTheSkyAndThePixelLeaves) {
  Shader s;
  s.scene.registers.shading.sky_nadir = s.scene.registers.shading.sky_zenith = {0.25f, 0.5f, 1};
  s.scene.contexts[0].hit_class = HitClass::miss;
  s.miss_source.push_at(9, 0);
  s.bench.run(300);
  const Cycle end = 10 + s.scene.pipelines.accumulate + 1;
  EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{end});
  EXPECT_EQ(s.free.cycles, std::vector<Cycle>{end});
  EXPECT_EQ(s.pixels.tokens[0].r, encode(0.25f));
  EXPECT_EQ(s.pixels.tokens[0].g, encode(0.5f));
  EXPECT_EQ(s.pixels.tokens[0].b, 255);
  EXPECT_EQ(s.pixels.tokens[0].hit_class, HitClass::miss);
  EXPECT_TRUE(s.memory.requests.empty());
}

TEST(Shading, AHitWithoutLightsAndNextRaysEndsThePixel) {
  Shader s;
  s.scene.registers.shading.ambient = {0.5f, 0.5f, 0.5f};
  s.hit_source.push_at(9, 3);
  s.bench.run(300);
  EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{Shader::shaded + s.last_sum(0) + 1});
  EXPECT_EQ(s.pixels.tokens[0].x, 3);
  EXPECT_EQ(s.pixels.tokens[0].r, encode(0.25f));
  EXPECT_TRUE(s.rays.tokens.empty());
}

TEST(Shading, TheFirstShadowRayFollowsTextureAndLight) {
  Shader s;
  s.light({0, 0, 5});
  s.hit_source.push_at(9, 0);
  s.bench.run(500);
  const Pipelines& p = s.scene.pipelines;
  // Texture filter, accumulation of emission and ambient, the light, one cycle for the light looked at, the channel.
  EXPECT_EQ(s.rays.cycles, std::vector<Cycle>{Shader::shaded + p.texture + p.accumulate + p.light + 1 + 1});
  EXPECT_EQ(s.sent, std::vector<RayKind>{RayKind::shadow});
  EXPECT_EQ(s.directions[0].z, 5.0f);
  EXPECT_EQ(s.scene.contexts[0].ray.tmax, 1.0f);
  EXPECT_EQ(p.texture, 15u);
  EXPECT_EQ(p.light, 3u + 36 + 3 + 36 + 30 + 9);
}

TEST(Shading, EachLightThatIsSkippedCostsACycle) {
  Shader s;
  s.light({0, 0, -5});  // behind
  s.light({0, 0, 5}, {});
  s.light({0, 0, 7});
  s.hit_source.push_at(9, 0);
  s.bench.run(500);
  const Pipelines& p = s.scene.pipelines;
  EXPECT_EQ(s.rays.cycles, std::vector<Cycle>{Shader::shaded + p.texture + p.accumulate + p.light + 3 + 1});
  EXPECT_EQ(s.directions[0].z, 7.0f);
  EXPECT_EQ(counter(s.shading, "lights"), 3u);
  EXPECT_EQ(counter(s.shading, "lights_skipped"), 2u);
}

TEST(Shading, LightsAreTakenInOrderOneShadowRayAtATime) {
  Shader s;
  for (float z : {5.0f, 6.0f, 7.0f}) s.light({0, 0, z});
  s.hit_source.push_at(9, 0);
  s.shadow_source.push_at(999, 0).push_at(1999, 0).push_at(2999, 0);
  s.bench.run(4000);
  const Pipelines& p = s.scene.pipelines;
  EXPECT_EQ(s.rays.cycles, (std::vector<Cycle>{Shader::shaded + p.texture + p.accumulate + p.light + 1 + 1,
                                               1000 + Cycle{p.accumulate} + p.light + 1 + 1,
                                               2000 + Cycle{p.accumulate} + p.light + 1 + 1}));
  ASSERT_EQ(s.directions.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(s.directions[static_cast<std::size_t>(i)].z, 5.0f + static_cast<float>(i));
  EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{3000 + Cycle{p.accumulate} + p.light + p.next_ray + 1});
}

TEST(Shading, AShadowedLightAddsNothing) {
  for (bool blocked : {false, true}) {
    Shader s;
    s.light({0, 0, 1}, {2, 2, 2});
    s.hit_source.push_at(9, 0);
    s.scene.contexts[0].found = blocked;  // what traversal leaves behind
    s.shadow_source.push_at(999, 0);
    s.bench.run(2000);
    EXPECT_EQ(s.pixels.tokens[0].r, blocked ? 0 : 255);
  }
}

}  // namespace
}  // namespace artu::hw::test
