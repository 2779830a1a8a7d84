#include "ref/renderer.h"

#include <cstring>
#include <vector>

#include "ref/color.h"
#include "ref/hit_point.h"
#include "ref/lights.h"
#include "ref/scatter.h"
#include "ref/texture.h"

namespace artu::ref {
namespace {

std::uint32_t bits(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  return b;
}

enum class Kind : std::uint8_t { primary, reflection, refraction };

template <class N>
struct Task {
  Vec3 origin, direction;
  Triple<N> weight;
  unsigned depth;
  Kind kind;
};

/// Shading in numbers of type N.
template <class N>
class RendererIn final : public Renderer {
 public:
  RendererIn(const traces::Scene& scene, const traces::Frame& frame, const Settings& settings, const Geometry& geometry)
      : scene_(scene), frame_(frame), settings_(settings), geometry_(geometry) {
    pending_.reserve(16);
  }
  void trace(std::uint32_t x, std::uint32_t y, Pixel& pixel) override;

 private:
  /// The sum of all that is seen along the ray, depth first; `first` is its own hit.
  Vec3 radiance(const Vec3& origin, const Vec3& direction, Hit& first);
  void shade_miss(const Task<N>& task, Triple<N>& acc) const;
  void shade_hit(const Task<N>& task, const Hit& hit, Triple<N>& acc);
  void spawn(const Task<N>& task, const HitPoint& point, const Surface<N>& surface, float ior);
  bool worth_tracing(const Triple<N>& weight) const;

  const traces::Scene& scene_;
  const traces::Frame& frame_;
  const Settings& settings_;
  const Geometry& geometry_;
  std::vector<Task<N>> pending_;  // a stack; kept between pixels so that no ray allocates
};

template <class N>
void RendererIn<N>::trace(std::uint32_t x, std::uint32_t y, Pixel& pixel) {
  Hit hit;
  const Vec3 color = radiance(camera_origin(frame_.camera, x, y), camera_direction(frame_.camera, x, y), hit);
  const Srgb& tables = srgb();
  pixel.r = tables.encode(color.x);
  pixel.g = tables.encode(color.y);
  pixel.b = tables.encode(color.z);
  pixel.primitive = hit.id;
  pixel.t_bits = hit.id < 0 ? 0 : bits(hit.at.t);
  pixel.hit_class = hit.id < 0                     ? HitClass::miss
                    : geometry_.is_dynamic(hit.id) ? HitClass::dynamic_geometry
                                                   : HitClass::static_geometry;
}

template <class N>
Vec3 RendererIn<N>::radiance(const Vec3& origin, const Vec3& direction, Hit& first) {
  Triple<N> acc;
  pending_.clear();
  pending_.push_back({origin, direction, {N(1), N(1), N(1)}, 0, Kind::primary});
  while (!pending_.empty()) {
    const Task<N> task = pending_.back();
    pending_.pop_back();
    if (task.kind == Kind::primary) ++rays_.primary;
    if (task.kind == Kind::reflection) ++rays_.reflection;
    if (task.kind == Kind::refraction) ++rays_.refraction;
    Hit hit;
    if (!is_dead(task.direction)) hit = geometry_.closest(geometry_.ray(task.origin, task.direction));
    if (task.kind == Kind::primary) first = hit;
    if (hit.id < 0) {
      shade_miss(task, acc);
    } else {
      shade_hit(task, hit, acc);
    }
  }
  return static_cast<Vec3>(acc);
}

template <class N>
void RendererIn<N>::shade_miss(const Task<N>& task, Triple<N>& acc) const {
  const N half(0.5f), s = half * N(task.direction.y) + half;
  const Triple<N> nadir = frame_.sky_nadir, zenith = frame_.sky_zenith;
  acc = acc + task.weight * (nadir + (zenith - nadir) * s);
}

template <class N>
void RendererIn<N>::shade_hit(const Task<N>& task, const Hit& hit, Triple<N>& acc) {
  const bool dynamic = geometry_.is_dynamic(hit.id);
  const traces::Mesh& mesh = dynamic ? frame_.dynamic : scene_.static_geometry;
  const auto triangle = static_cast<std::size_t>(dynamic ? hit.id - geometry_.dynamic.first_id() : hit.id);
  const traces::Material& material = scene_.materials[mesh.materials[triangle]];
  const HitPoint point = hit_point(mesh, triangle, task.direction, hit.at, settings_.precision.triangle);

  Triple<N> tex{N(1), N(1), N(1)};
  if (material.texture >= 0) tex = sample<N>(scene_.textures[material.texture], point.uv);
  const Surface<N> surface = surface_of(material, tex * point.color);
  acc = acc + task.weight * (material.emission + surface.kd * frame_.ambient);

  for (const traces::Light& light : frame_.lights) {
    LightSample<N> arriving;
    Triple<N> added;
    if (!sample_light(light, point.outside, arriving)) continue;
    if (!contribution(arriving, point, task.direction, surface, material.specular_log2, task.weight, added)) continue;
    ++rays_.shadow;
    if (!geometry_.occluded(geometry_.ray(point.outside, arriving.shadow, arriving.tmax))) acc = acc + added;
  }
  if (task.depth < settings_.max_depth) spawn(task, point, surface, material.ior);
}

template <class N>
void RendererIn<N>::spawn(const Task<N>& task, const HitPoint& point, const Surface<N>& surface, float ior) {
  const Scatter<N> next = scatter(point, task.direction, surface.kr, surface.kt, ior);
  // Last in, first out: the reflection and all below it come before the refraction, as the contract orders the sum.
  const Triple<N> refraction = task.weight * next.refraction;
  if (worth_tracing(refraction) && !is_dead(next.refracted)) {
    pending_.push_back({point.inside, next.refracted, refraction, task.depth + 1, Kind::refraction});
  }
  const Triple<N> reflection = task.weight * next.reflection;
  if (worth_tracing(reflection)) {
    const Vec3 direction = reflected(point, task.direction);
    if (!is_dead(direction)) {
      pending_.push_back({point.outside, direction, reflection, task.depth + 1, Kind::reflection});
    }
  }
}

template <class N>
bool RendererIn<N>::worth_tracing(const Triple<N>& weight) const {
  const auto w = static_cast<float>(largest(weight));
  return w >= settings_.min_weight && w > 0;
}

}  // namespace

std::unique_ptr<Renderer> Renderer::make(const traces::Scene& scene, const traces::Frame& frame,
                                         const Settings& settings, const Geometry& geometry, bool emulate) {
  const auto in = [&](auto format) -> std::unique_ptr<Renderer> {
    return std::make_unique<RendererIn<typename decltype(format)::Type>>(scene, frame, settings, geometry);
  };
  return emulate ? with_number(settings.precision.shading, in) : with_format(settings.precision.shading, in);
}

}  // namespace artu::ref
