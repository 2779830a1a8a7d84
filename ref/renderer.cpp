#include "ref/renderer.h"

#include <cstring>

#include "ref/color.h"
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

}  // namespace

Renderer::Renderer(const traces::Scene& scene, const traces::Frame& frame, const Settings& settings,
                   const Geometry& geometry)
    : scene_(scene), frame_(frame), settings_(settings), geometry_(geometry) {
  pending_.reserve(16);
}

void Renderer::trace(std::uint32_t x, std::uint32_t y, Pixel& pixel) {
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

Vec3 Renderer::radiance(const Vec3& origin, const Vec3& direction, Hit& first) {
  Vec3 acc;
  pending_.clear();
  pending_.push_back({origin, direction, {1, 1, 1}, 0, Kind::primary});
  while (!pending_.empty()) {
    const Task task = pending_.back();
    pending_.pop_back();
    if (task.kind == Kind::primary) ++rays_.primary;
    if (task.kind == Kind::reflection) ++rays_.reflection;
    if (task.kind == Kind::refraction) ++rays_.refraction;
    Hit hit;
    if (!is_dead(task.direction)) hit = geometry_.closest(make_ray(task.origin, task.direction));
    if (task.kind == Kind::primary) first = hit;
    if (hit.id < 0) {
      shade_miss(task, acc);
    } else {
      shade_hit(task, hit, acc);
    }
  }
  return acc;
}

void Renderer::shade_miss(const Task& task, Vec3& acc) const {
  const float s = 0.5f * task.direction.y + 0.5f;
  acc = acc + task.weight * (frame_.sky_nadir + (frame_.sky_zenith - frame_.sky_nadir) * s);
}

void Renderer::shade_hit(const Task& task, const Hit& hit, Vec3& acc) {
  const bool dynamic = geometry_.is_dynamic(hit.id);
  const traces::Mesh& mesh = dynamic ? frame_.dynamic : scene_.static_geometry;
  const auto triangle = static_cast<std::size_t>(dynamic ? hit.id - geometry_.dynamic.first_id() : hit.id);
  const traces::Material& material = scene_.materials[mesh.materials[triangle]];
  const HitPoint point = hit_point(mesh, triangle, task.direction, hit.at);

  Vec3 texture_color{1, 1, 1};
  if (material.texture >= 0) texture_color = sample(scene_.textures[material.texture], point.uv);
  const Surface surface = surface_of(material, texture_color * point.color);
  acc = acc + task.weight * (material.emission + surface.kd * frame_.ambient);

  for (const traces::Light& light : frame_.lights) {
    LightSample arriving;
    Vec3 added;
    if (!sample_light(light, point.outside, arriving)) continue;
    if (!contribution(arriving, point, task.direction, surface, material.specular_log2, task.weight, added)) continue;
    ++rays_.shadow;
    if (!geometry_.occluded(make_ray(point.outside, arriving.shadow, arriving.tmax))) acc = acc + added;
  }
  if (task.depth < settings_.max_depth) spawn(task, point, surface.kr, surface.kt, material.ior);
}

void Renderer::spawn(const Task& task, const HitPoint& point, const Vec3& kr, const Vec3& kt, float ior) {
  const Scatter next = scatter(point, task.direction, kr, kt, ior);
  // Last in, first out: the reflection and all below it come before the refraction, as the contract orders the sum.
  const Vec3 refraction = task.weight * next.refraction;
  if (worth_tracing(refraction) && !is_dead(next.refracted)) {
    pending_.push_back({point.inside, next.refracted, refraction, task.depth + 1, Kind::refraction});
  }
  const Vec3 reflection = task.weight * next.reflection;
  if (worth_tracing(reflection)) {
    const Vec3 direction = reflected(point, task.direction);
    if (!is_dead(direction)) {
      pending_.push_back({point.outside, direction, reflection, task.depth + 1, Kind::reflection});
    }
  }
}

bool Renderer::worth_tracing(const Vec3& weight) const {
  const float w = largest(weight);
  return w >= settings_.min_weight && w > 0;
}

}  // namespace artu::ref
