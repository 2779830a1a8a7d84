// The shading unit: what it fetches, in which order it sends rays, and when.
#include "hw/ray_core/shading.h"

#include <gtest/gtest.h>

#include "hw/datapath/color.h"
#include "unit/hw/core_support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle hit_latency = 2;

struct Shader {
  explicit Shader(std::size_t contexts = 32)
      : scene(contexts),
        shading(bench.block<Shading>("shading", scene.registers, scene.image, scene.contexts, scene.pipelines)),
        memory(bench.block<ScriptedMemory>("memory", texels, hit_latency, hit_latency)),
        hit_source(bench.block<Source<Slot>>("hit_source", hits)),
        miss_source(bench.block<Source<Slot>>("miss_source", misses)),
        shadow_source(bench.block<Source<Slot>>("shadow_source", shadows)),
        rays(bench.block<Sink<Slot>>("rays", next_rays)),
        free(bench.block<Sink<Slot>>("free", freed)),
        pixels(bench.block<Sink<PixelToken>>("pixels", out)) {
    hits.bind(hit_source, shading);
    misses.bind(miss_source, shading);
    shadows.bind(shadow_source, shading);
    next_rays.bind(shading, rays);
    freed.bind(shading, free);
    out.bind(shading, pixels);
    texels.bind(shading, memory);
    shading.bind({&hits, &misses, &shadows, &next_rays, &freed, &out, &texels});
    rays.open = [this](Cycle) {
      // What the ray generator would see: the kind and direction of the ray in flight.
      const RayContext& context = scene.contexts[next_rays.front()];
      sent.push_back(context.kind);
      directions.push_back(context.ray.direction);
      depths.push_back(context.depth);
      return true;
    };
    material().diffuse = {0.5f, 0.5f, 0.5f};
    material().ior = 1;
    scene.registers.shading.max_depth = 3;
    for (Slot slot : slots(contexts)) hit(slot);
  }
  MaterialRecord& material() { return scene.image.at<MaterialRecord>(scene.registers.descriptor.materials); }
  /// A hit on a floor, seen from above.
  void hit(Slot slot) {
    scene.ray(slot, 1, 1);
    RayContext& context = scene.contexts[slot];
    context.pixel = {slot, 1};
    context.hit_class = HitClass::static_geometry;
    context.material = scene.registers.descriptor.materials;
    Surface& surface = context.surface;
    surface.geometric_normal = surface.shading_normal = {0, 0, 1};
    surface.color = {1, 1, 1};
  }
  void light(Vector position, Vector color = {1, 1, 1}) {
    LightRecord light{};
    light.type = LightType::point;
    light.position = position;
    light.color = color;
    light.range = 1000;
    scene.registers.lights.push_back(light);
  }
  /// A hit pushed in cycle 9 is shaded in this cycle: arrival 10, requests in 10 and 11, the second line's way.
  static constexpr Cycle shaded = 11 + 1 + hit_latency;

  Bench bench;
  CoreScene scene;
  Fifo<Slot>& hits = bench.fifo<Slot>("hits", 5);
  Fifo<Slot>& misses = bench.fifo<Slot>("misses", 5);
  Fifo<Slot>& shadows = bench.fifo<Slot>("shadows", 5);
  Fifo<Slot>& next_rays = bench.fifo<Slot>("next_rays", 32);
  Fifo<Slot>& freed = bench.fifo<Slot>("freed", 32);
  Fifo<PixelToken>& out = bench.fifo<PixelToken>("out", 5);
  MemoryLink& texels = bench.link("texels", 4, 1, hit_latency);
  Shading& shading;
  ScriptedMemory& memory;
  Source<Slot>&hit_source, &miss_source, &shadow_source;
  Sink<Slot>&rays, &free;
  Sink<PixelToken>& pixels;
  std::vector<RayKind> sent;
  std::vector<Vector> directions;
  std::vector<unsigned> depths;
};

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
  // The pixel's end is not charged with the datapath's latency: it leaves in the cycle in which it is looked at.
  EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{10 + 1});
  EXPECT_EQ(s.free.cycles, std::vector<Cycle>{10 + 1});
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
  EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{Shader::shaded + 1});  // see the miss: no latency at the end
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
  EXPECT_EQ(s.rays.cycles,
            (std::vector<Cycle>{Shader::shaded + p.texture + p.accumulate + p.light + 1 + 1,
                                1000 + Cycle{p.accumulate} + p.light + 1 + 1, 2000 + Cycle{p.accumulate} + p.light + 1 + 1}));
  ASSERT_EQ(s.directions.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(s.directions[static_cast<std::size_t>(i)].z, 5.0f + static_cast<float>(i));
  EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{3000 + 1});
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

TEST(Shading, ReflectionIsFollowedToItsEndBeforeRefraction) {
  Shader s;
  s.material().mirror = {0.5f, 0.5f, 0.5f};
  s.material().transmission = {0.5f, 0.5f, 0.5f};
  s.hit_source.push_at(9, 0).push_at(999, 0);       // the reflection ray hits the same glass again
  s.miss_source.push_at(1999, 0).push_at(2999, 0).push_at(3999, 0);
  s.bench.run(5000);
  EXPECT_EQ(s.sent, (std::vector<RayKind>{RayKind::reflection, RayKind::reflection, RayKind::refraction,
                                          RayKind::refraction}));
  EXPECT_EQ(s.depths, (std::vector<unsigned>{1, 2, 2, 1}));
  const Pipelines& p = s.scene.pipelines;
  EXPECT_EQ(s.rays.cycles[0],
            Shader::shaded + p.texture + p.accumulate + p.light + p.next_ray + 1);  // no light is looked at
  EXPECT_EQ(s.rays.cycles[2], 2000 + Cycle{p.accumulate} + 1);
  EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{4000 + 1});
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
    EXPECT_EQ(s.pixels.cycles, std::vector<Cycle>{Shader::shaded + lines - 1 + 1 + hit_latency + 1});
    EXPECT_EQ(counter(s.shading, "textured"), 1u);
  }
}

TEST(Shading, ManyHitsAreBoundByTheirTwoLinesEach) {
  Shader s;
  for (Slot slot : slots(32)) s.hit_source.push_at(9, slot);
  s.bench.run(500);
  EXPECT_EQ(s.pixels.cycles, every(Shader::shaded + 1, 32, 2));
  EXPECT_EQ(s.memory.cycles, every(11, 64));
}

TEST(Shading, MissesAreShadedOneACycle) {
  Shader s;
  for (Slot slot : slots(32)) s.miss_source.push_at(9, slot);
  s.bench.run(500);
  EXPECT_EQ(s.pixels.cycles, every(11, 32));
}

TEST(Shading, AHitOccupiesTheShaderForACycleALight) {
  Shader s;
  for (int i = 0; i < 5; ++i) s.light({0, 0, -5});
  for (Slot slot : slots(16)) s.hit_source.push_at(9, slot);
  s.bench.run(500);
  EXPECT_EQ(s.pixels.cycles, every(Shader::shaded + 1, 16, 5));
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
