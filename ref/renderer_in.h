// The renderer as a template on its arithmetic (docs/arithmetic.md section 7): that of the contract in renderer.cpp,
// all of it in binary64 in binary64.cpp.
#pragma once

#include <cstring>
#include <vector>

#include "ref/color.h"
#include "ref/hit_point.h"
#include "ref/lights.h"
#include "ref/renderer.h"
#include "ref/scatter.h"
#include "ref/texture.h"

namespace artu::ref {

/// Shading in numbers of type N; rays by Tests and in its numbers.
template <class N, class Tests>
class RendererIn final : public Renderer {
 public:
  RendererIn(const traces::Scene& scene, const traces::Frame& frame, const Settings& settings,
             const GeometryOf<Tests>& geometry)
      : scene_(scene), frame_(frame), settings_(settings), geometry_(geometry) {
    pending_.reserve(16);
  }
  void trace(std::uint32_t x, std::uint32_t y, Pixel& pixel) override;

 private:
  using F = typename Tests::Number;
  using HitPoint = HitPointIn<F>;
  enum class Kind : std::uint8_t { primary, reflection, refraction };
  struct Task {
    Vector<F> origin, direction;
    Triple<N> weight;
    unsigned depth;
    Kind kind;
  };

  /// The sum of all that is seen along the ray, depth first; `first` is its own hit.
  Triple<N> radiance(const Vector<F>& origin, const Vector<F>& direction, HitIn<F>& first);
  void shade_miss(const Task& task, Triple<N>& acc) const;
  void shade_hit(const Task& task, const HitIn<F>& hit, Triple<N>& acc);
  void spawn(const Task& task, const HitPoint& point, const Surface<N>& surface, float ior);
  bool worth_tracing(const Triple<N>& weight) const;

  const traces::Scene& scene_;
  const traces::Frame& frame_;
  const Settings& settings_;
  const GeometryOf<Tests>& geometry_;
  std::vector<Task> pending_;  // a stack; kept between pixels so that no ray allocates
};

template <class N, class Tests>
void RendererIn<N, Tests>::trace(std::uint32_t x, std::uint32_t y, Pixel& pixel) {
  HitIn<F> hit;
  const Triple<N> color =
      radiance(camera_origin<F>(frame_.camera, x, y), camera_direction<F>(frame_.camera, x, y), hit);
  const SrgbIn<F>& tables = srgb<F>();
  pixel.r = tables.encode(static_cast<F>(color.x));
  pixel.g = tables.encode(static_cast<F>(color.y));
  pixel.b = tables.encode(static_cast<F>(color.z));
  pixel.primitive = hit.id;
  const auto t = hit.id < 0 ? 0 : static_cast<float>(hit.at.t);
  std::memcpy(&pixel.t_bits, &t, sizeof t);
  pixel.hit_class = hit.id < 0                     ? HitClass::miss
                    : geometry_.is_dynamic(hit.id) ? HitClass::dynamic_geometry
                                                   : HitClass::static_geometry;
}

template <class N, class Tests>
Triple<N> RendererIn<N, Tests>::radiance(const Vector<F>& origin, const Vector<F>& direction, HitIn<F>& first) {
  Triple<N> acc;
  pending_.clear();
  pending_.push_back({origin, direction, {N(1), N(1), N(1)}, 0, Kind::primary});
  while (!pending_.empty()) {
    const Task task = pending_.back();
    pending_.pop_back();
    if (task.kind == Kind::primary) ++rays_.primary;
    if (task.kind == Kind::reflection) ++rays_.reflection;
    if (task.kind == Kind::refraction) ++rays_.refraction;
    HitIn<F> hit;
    if (!is_dead(task.direction)) hit = geometry_.closest(geometry_.ray(task.origin, task.direction));
    if (task.kind == Kind::primary) first = hit;
    if (hit.id < 0) {
      shade_miss(task, acc);
    } else {
      shade_hit(task, hit, acc);
    }
  }
  return acc;
}

template <class N, class Tests>
void RendererIn<N, Tests>::shade_miss(const Task& task, Triple<N>& acc) const {
  const N half(0.5f), s = half * N(task.direction.y) + half;
  const Triple<N> nadir = frame_.sky_nadir, zenith = frame_.sky_zenith;
  acc = acc + task.weight * (nadir + (zenith - nadir) * s);
}

template <class N, class Tests>
void RendererIn<N, Tests>::shade_hit(const Task& task, const HitIn<F>& hit, Triple<N>& acc) {
  const bool dynamic = geometry_.is_dynamic(hit.id);
  const traces::Mesh& mesh = dynamic ? frame_.dynamic : scene_.static_geometry;
  const auto triangle = static_cast<std::size_t>(dynamic ? hit.id - geometry_.dynamic.first_id() : hit.id);
  const traces::Material& material = scene_.materials[mesh.materials[triangle]];
  const HitPoint point = hit_point(mesh, triangle, task.direction, hit.at, geometry_.tests().triangle_bits());

  Triple<N> tex{N(1), N(1), N(1)};
  if (material.texture >= 0) tex = sample<N>(scene_.textures[material.texture], point.uv);
  const Surface<N> surface = surface_of(material, tex * point.color);
  acc = acc + task.weight * (material.emission + surface.kd * frame_.ambient);

  for (const traces::Light& light : frame_.lights) {
    LightSample<N, F> arriving;
    Triple<N> added;
    if (!sample_light(light, point.outside, arriving) ||
        !contribution(arriving, point, task.direction, surface, material.specular_log2, task.weight, added)) {
      if (settings_.every_light && can_aim<F>(light, point.outside)) ++rays_.shadow;
      continue;
    }
    ++rays_.shadow;
    if (!geometry_.occluded(geometry_.ray(point.outside, arriving.shadow, arriving.tmax))) acc = acc + added;
  }
  if (task.depth < settings_.max_depth) spawn(task, point, surface, material.ior);
}

template <class N, class Tests>
void RendererIn<N, Tests>::spawn(const Task& task, const HitPoint& point, const Surface<N>& surface, float ior) {
  const Scatter<N, F> next = scatter(point, task.direction, surface.kr, surface.kt, ior);
  // Last in, first out: the reflection and all below it come before the refraction, as the contract orders the sum.
  const Triple<N> refraction = task.weight * next.refraction;
  if (worth_tracing(refraction) && !is_dead(next.refracted)) {
    pending_.push_back({point.inside, next.refracted, refraction, task.depth + 1, Kind::refraction});
  }
  const Triple<N> reflection = task.weight * next.reflection;
  if (worth_tracing(reflection)) {
    const Vector<F> direction = reflected(point, task.direction);
    if (!is_dead(direction)) {
      pending_.push_back({point.outside, direction, reflection, task.depth + 1, Kind::reflection});
    }
  }
}

template <class N, class Tests>
bool RendererIn<N, Tests>::worth_tracing(const Triple<N>& weight) const {
  const auto w = static_cast<F>(largest(weight));
  return w >= settings_.min_weight && w > 0;
}

}  // namespace artu::ref
