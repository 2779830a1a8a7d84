// The shading unit with scripted neighbours, and a floor that its rays hit.
#pragma once

#include <gtest/gtest.h>

#include "hw/ray_core/shading.h"
#include "unit/hw/core_support.h"

namespace artu::hw::test {

inline constexpr Cycle hit_latency = 2;

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
  /// From a hit's last line to the end of a pixel none of whose lights sends a shadow ray.
  Cycle last_sum(Cycle lights) const {
    const Pipelines& p = scene.pipelines;
    return p.texture + p.accumulate + p.light + lights + p.next_ray;
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

}  // namespace artu::hw::test
