#include "ref/tracer.h"

#include <cstring>

#include "ref/geometry.h"

namespace artu::ref {
namespace {

TracedHit traced(const Hit& best) {
  TracedHit out;
  if (best.id < 0) return out;
  out.hit = true;
  out.primitive = best.id;
  std::memcpy(&out.t_bits, &best.at.t, sizeof out.t_bits);
  out.t = best.at.t;
  out.u = best.at.u;
  out.v = best.at.v;
  out.det = best.at.det;
  return out;
}

/// Calls `visit(id, hit)` for every triangle that is hit, until it returns false.
template <typename Visit>
void each_hit(const EmbreeScene& scene, const Ray& ray, const Visit& visit) {
  std::int64_t id = scene.first_id();
  for (const Triangle& triangle : scene.triangles()) {
    TriangleHit hit;
    if (scene.tests().intersect(ray, triangle, hit) && !visit(id, hit)) return;
    ++id;
  }
}

}  // namespace

struct Tracer::Impl {
  explicit Impl(const Precision& precision) : tests(precision), fixed(device, tests), dynamic(device, tests) {}

  const EmbreeDevice device;  // before the scenes that live in it
  const HitTests tests;
  EmbreeScene fixed, dynamic;
  Geometry geometry() const { return {fixed, dynamic}; }
};

Tracer::Tracer(const traces::Mesh& fixed, const traces::Mesh& dynamic, const Extent& origins,
               const Precision& precision)
    : impl_(std::make_unique<Impl>(precision)) {
  impl_->fixed.set(fixed, 0);
  impl_->dynamic.set(dynamic, static_cast<std::int64_t>(fixed.triangle_count()));
  Extent geometry = impl_->fixed.extent();
  geometry.add(impl_->dynamic.extent());
  const double padding = required_padding(geometry, origins, precision);
  impl_->fixed.build(padding);
  impl_->dynamic.build(padding);
}

Tracer::~Tracer() = default;

TracedHit Tracer::closest(const traces::Vec3& origin, const traces::Vec3& direction, float tmax) const {
  if (is_dead(direction)) return {};
  return traced(impl_->geometry().closest(impl_->tests.ray(origin, direction, tmax)));
}

bool Tracer::occluded(const traces::Vec3& origin, const traces::Vec3& direction, float tmax) const {
  return !is_dead(direction) && impl_->geometry().occluded(impl_->tests.ray(origin, direction, tmax));
}

TracedHit Tracer::closest_of_all(const traces::Vec3& origin, const traces::Vec3& direction, float tmax) const {
  if (is_dead(direction)) return {};
  const Ray ray = impl_->tests.ray(origin, direction, tmax);
  Hit best;
  for (const EmbreeScene* scene : {&impl_->fixed, &impl_->dynamic}) {
    each_hit(*scene, ray, [&](std::int64_t id, const TriangleHit& hit) {
      improve(best, id, hit);
      return true;
    });
  }
  return traced(best);
}

bool Tracer::occluded_by_any(const traces::Vec3& origin, const traces::Vec3& direction, float tmax) const {
  if (is_dead(direction)) return false;
  const Ray ray = impl_->tests.ray(origin, direction, tmax);
  bool found = false;
  for (const EmbreeScene* scene : {&impl_->fixed, &impl_->dynamic}) {
    each_hit(*scene, ray, [&](std::int64_t, const TriangleHit&) {
      found = true;
      return false;
    });
  }
  return found;
}

}  // namespace artu::ref
