// A pixel from its primary ray to its colour: what a ray core does, without time (docs/arithmetic.md section 7).
#pragma once

#include "hw/datapath/color.h"
#include "hw/datapath/selective.h"
#include "hw/frame_registers.h"
#include "hw/functional/walker.h"

namespace artu::hw {

struct TracedPixel {
  Rgb color;
  HitClass hit_class = HitClass::miss;
  std::int64_t primitive = -1;  // of the primary ray, or -1
  std::uint32_t t_bits = 0;     // of its hit
};

template <class Tap>
class PixelTracer {
 public:
  PixelTracer(const UnitConfig& config, const FrameRegisters& registers, const MemoryImage& image, bool portable,
              bool overflows, FunctionalCounts& counts, Tap& tap)
      : registers_(registers),
        image_(image),
        memory_(registers.descriptor, image),
        steps_(shading_steps(static_cast<int>(config.precision.shading))),
        triangle_bits_(static_cast<int>(config.precision.triangle)),
        counts_(counts),
        tap_(tap),
        walker_(config, memory_, portable, overflows, counts, tap) {}

  TracedPixel trace(std::uint32_t x, std::uint32_t y) {
    Ray ray = primary_ray(registers_.descriptor.camera, x, y);
    Vector weight{1, 1, 1};
    std::uint8_t depth = 0;
    sum_ = {};
    pending_.clear();
    Found found;
    closest(RayKind::primary, ray, found);
    TracedPixel pixel;
    if (found.hit) {
      pixel.hit_class = found.dynamic ? HitClass::dynamic_geometry : HitClass::static_geometry;
      pixel.primitive = found.primitive;
      pixel.t_bits = bits_of(found.best.t);
    }
    for (;;) {
      if (found.hit) {
        shade(ray, found, weight, depth);
      } else {
        ++counts_.sky;
        sum_ = steps_.add_weighted(sum_, weight, steps_.sky(registers_.shading, ray.direction));
      }
      if (pending_.empty()) break;
      const PendingRay& next = pending_.take();
      ray.origin = next.origin;
      ray.direction = next.direction;
      ray.tmax = two_pow_100;
      weight = next.weight;
      depth = next.depth;
      closest(next.kind, ray, found);
    }
    tap_.end_of_pixel();
    pixel.color = {encode(sum_.x), encode(sum_.y), encode(sum_.z)};
    return pixel;
  }

 private:
  void begin(RayKind kind, Ray& ray) {
    ++counts_.rays[static_cast<std::size_t>(kind)];
    tap_.ray(kind);
    if (!is_zero(ray.direction)) walker_.tests().set_up(ray);
  }
  void closest(RayKind kind, Ray& ray, Found& found) {
    begin(kind, ray);
    walker_.template walk<false>(ray, found);
  }

  void shade(const Ray& ray, const Found& found, Vector weight, std::uint8_t depth) {
    const FrameDescriptor& frame = registers_.descriptor;
    const auto& triangle = reinterpret_cast<const TriangleRecord*>(memory_.triangles[found.dynamic])[found.triangle];
    const Address attributes = (found.dynamic ? frame.dynamic_attributes : frame.static_attributes) +
                               Address{triangle.attributes} * sizeof(AttributeRecord);
    const Address at = frame.materials + Address{triangle.material} * sizeof(MaterialRecord);
    const auto& material = image_.at<MaterialRecord>(at);
    tap_.hit_point(memory_.address_of(&triangle), attributes);
    tap_.material(at);
    ++counts_.hit_points;
    const Surface surface =
        surface_at(ray, found.best, triangle, image_.at<AttributeRecord>(attributes), triangle_bits_);
    ShadedPoint point;
    const Vector base = steps_.begin_shading(registers_.shading, surface, material, texture(material, surface),
                                             ray.direction, weight, point);
    sum_ = steps_.add_weighted(sum_, weight, base);
    light(point);
    if (depth < registers_.shading.max_depth) {
      pending_.add(steps_.next_rays(registers_.shading, point), point, depth);
    }
  }

  Vector texture(const MaterialRecord& material, const Surface& surface) {
    TextureFootprint at{};
    if (material.texels != 0) {
      ++counts_.textured;
      at = footprint(material, surface.u, surface.v);
      for (int i = 0; i < 4; ++i) {
        tap_.texel(texel_address(material.texels, material.width, at.x[i & 1], at.y[i >> 1]));
      }
    } else if (registers_.skip.texture) {
      ++counts_.textures_skipped;
    } else {
      tap_.texel(registers_.descriptor.materials);
    }
    return texture_at(steps_, image_, material, at);
  }

  void light(const ShadedPoint& point) {
    std::uint32_t light = 0;
    ShadowRay shadow;
    Ray ray;
    Found found;
    ray.origin = point.outside;
    while (next_shadow_ray(steps_, registers_.lights, point, light, shadow, registers_.skip.shadow)) {
      ray.direction = shadow.direction;
      ray.tmax = shadow.tmax;
      begin(RayKind::shadow, ray);
      if (registers_.skip.any_hit) {
        walker_.template walk<true>(ray, found);
      } else {
        walker_.template walk<false>(ray, found);
      }
      if (!found.hit) sum_ = steps_.add(sum_, shadow.contribution);
      --counts_.lights_skipped;
    }
    counts_.lights += light;
    counts_.lights_skipped += light;
  }

  const FrameRegisters& registers_;
  const MemoryImage& image_;
  const FrameMemory memory_;
  const ShadingSteps& steps_;
  const int triangle_bits_;
  FunctionalCounts& counts_;
  Tap& tap_;
  Walker<Tap> walker_;
  Vector sum_;
  PendingRays pending_;
};

}  // namespace artu::hw
