#include "ref/embree_scene.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <new>
#include <stdexcept>
#include <string>

namespace artu::ref {
namespace {

// Embree silently drops primitives whose box reaches 1.844e18, and traces may hold coordinates up to 2^62.
constexpr float embree_limit = 1.8e18f;

// Travels through Embree with a ray.  Embree hands the callbacks the pointer to `embree`.
template <class Tests>
struct TraceContext {
  RTCIntersectContext embree;
  const typename Tests::Ray* ray;
  HitIn<typename Tests::Number> best;
};

// Embree stops the program at a ray that it thinks is not valid; the contract knows no such rays.
template <class Ray>
bool embree_takes(const Ray& ray) {
  const auto fits = [](const auto& v) {
    return std::fabs(v.x) < embree_limit && std::fabs(v.y) < embree_limit && std::fabs(v.z) < embree_limit;
  };
  return fits(ray.origin) && fits(ray.direction);
}

template <class Ray>
void fill(RTCRay& out, const Ray& ray, float tfar) {
  const auto origin = static_cast<Vec3>(ray.origin), direction = static_cast<Vec3>(ray.direction);
  out.org_x = origin.x;
  out.org_y = origin.y;
  out.org_z = origin.z;
  out.tnear = 0;  // a box that the ray only touches at 0 is visited: Embree compares with <=
  out.dir_x = direction.x;
  out.dir_y = direction.y;
  out.dir_z = direction.z;
  out.time = 0;
  out.tfar = tfar;
  out.mask = ~0u;
  out.id = 0;
  out.flags = 0;
}

// Binary32 strictly outside of a binary64 bound: the padding must not be lost where a coordinate's ulp exceeds it.
float below(double x) { return std::nextafter(static_cast<float>(x), -HUGE_VALF); }
float above(double x) { return std::nextafter(static_cast<float>(x), HUGE_VALF); }

[[noreturn]] void fail(const char* what, RTCError error) {
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(std::string("Embree: ") + what + ", error " + std::to_string(error));
}

}  // namespace

EmbreeDevice::EmbreeDevice() : device_(rtcNewDevice("threads=1")) {
  if (!device_) fail("no device", rtcGetDeviceError(nullptr));
}

void EmbreeDevice::Release::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }

void EmbreeDevice::check(const char* what) const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error != RTC_ERROR_NONE) fail(what, error);
}

template <class Tests>
void EmbreeSceneOf<Tests>::Release::operator()(RTCSceneTy* scene) const {
  rtcReleaseScene(scene);
}

template <class Tests>
EmbreeSceneOf<Tests>::EmbreeSceneOf(const EmbreeDevice& device, const Tests& tests) : device_(device), tests_(tests) {}

template <class Tests>
void EmbreeSceneOf<Tests>::set(const traces::Mesh& mesh, std::int64_t first_id) {
  scene_.reset();
  first_id_ = first_id;
  triangles_.resize(mesh.triangle_count());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3& p = mesh.positions[mesh.indices[3 * i + corner]];
      triangles_[i].v[3 * corner] = p.x;
      triangles_[i].v[3 * corner + 1] = p.y;
      triangles_[i].v[3 * corner + 2] = p.z;
    }
  }
  extent_ = extent_of(triangles_);
}

template <class Tests>
Box EmbreeSceneOf<Tests>::padded(std::uint32_t triangle) const {
  const Box box = triangle_box(triangles_[triangle]);
  return {{below(box.lo.x - padding_), below(box.lo.y - padding_), below(box.lo.z - padding_)},
          {above(box.hi.x + padding_), above(box.hi.y + padding_), above(box.hi.z + padding_)}};
}

template <class Tests>
void EmbreeSceneOf<Tests>::build(double padding) {
  padding_ = padding;
  oversized_.clear();
  scene_.reset();
  if (triangles_.empty()) return;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const Box box = padded(i);
    if (max(largest_magnitude(box.lo), largest_magnitude(box.hi)) >= embree_limit) oversized_.push_back(i);
  }
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(triangles_.size()));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(geometry, bounds_callback, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_callback);
  rtcSetGeometryOccludedFunction(geometry, occluded_callback);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_.get());
  device_.check("tree build");
}

// Embree calls this with subnormals flushed to zero, which costs at most 2^-126: the padding is at least 2^-58.
template <class Tests>
void EmbreeSceneOf<Tests>::bounds_callback(const RTCBoundsFunctionArguments* args) {
  const auto& scene = *static_cast<const EmbreeSceneOf*>(args->geometryUserPtr);
  const Box box = scene.padded(args->primID);
  RTCBounds& out = *args->bounds_o;
  out.lower_x = box.lo.x;
  out.lower_y = box.lo.y;
  out.lower_z = box.lo.z;
  out.upper_x = box.hi.x;
  out.upper_y = box.hi.y;
  out.upper_z = box.hi.z;
}

template <class Tests>
void EmbreeSceneOf<Tests>::intersect_callback(const RTCIntersectFunctionNArguments* args) {
  const auto& scene = *static_cast<const EmbreeSceneOf*>(args->geometryUserPtr);
  auto& context = *reinterpret_cast<TraceContext<Tests>*>(args->context);
  const Triangle& triangle = scene.triangles_[args->primID];
  TriangleHitIn<typename Tests::Number> hit;
  if (scene.tests_.surely_misses(*context.ray, triangle)) return;
  if (!scene.tests_.intersect(*context.ray, triangle, hit)) return;
  if (!improve(context.best, scene.first_id_ + args->primID, hit)) return;
  reinterpret_cast<RTCRayHit*>(args->rayhit)->ray.tfar = scene.tests_.tfar(hit.t);
}

template <class Tests>
void EmbreeSceneOf<Tests>::occluded_callback(const RTCOccludedFunctionNArguments* args) {
  const auto& scene = *static_cast<const EmbreeSceneOf*>(args->geometryUserPtr);
  const auto& context = *reinterpret_cast<TraceContext<Tests>*>(args->context);
  const Triangle& triangle = scene.triangles_[args->primID];
  TriangleHitIn<typename Tests::Number> hit;
  if (scene.tests_.surely_misses(*context.ray, triangle)) return;
  if (!scene.tests_.intersect(*context.ray, triangle, hit)) return;
  reinterpret_cast<RTCRay*>(args->ray)->tfar = -HUGE_VALF;  // Embree's sign for "occluded, stop"
}

template <class Tests>
void EmbreeSceneOf<Tests>::closest(const Ray& ray, Hit& best) const {
  if (!scene_) return;
  TriangleHitIn<typename Tests::Number> hit;
  if (!embree_takes(ray)) {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      if (tests_.intersect(ray, triangles_[i], hit)) improve(best, first_id_ + i, hit);
    }
    return;
  }
  for (const std::uint32_t i : oversized_) {
    if (tests_.intersect(ray, triangles_[i], hit)) improve(best, first_id_ + i, hit);
  }
  TraceContext<Tests> context;
  rtcInitIntersectContext(&context.embree);
  context.ray = &ray;
  context.best = best;
  RTCRayHit rayhit;
  fill(rayhit.ray, ray, tests_.tfar(best.id < 0 ? ray.tmax : best.at.t));
  rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_.get(), &context.embree, &rayhit);
  best = context.best;
}

template <class Tests>
bool EmbreeSceneOf<Tests>::occluded(const Ray& ray) const {
  if (!scene_) return false;
  TriangleHitIn<typename Tests::Number> hit;
  if (!embree_takes(ray)) {
    for (const Triangle& triangle : triangles_) {
      if (tests_.intersect(ray, triangle, hit)) return true;
    }
    return false;
  }
  for (const std::uint32_t i : oversized_) {
    if (tests_.intersect(ray, triangles_[i], hit)) return true;
  }
  TraceContext<Tests> context;
  rtcInitIntersectContext(&context.embree);
  context.ray = &ray;
  RTCRay embree_ray;
  fill(embree_ray, ray, tests_.tfar(ray.tmax));
  rtcOccluded1(scene_.get(), &context.embree, &embree_ray);
  return embree_ray.tfar < 0;
}

template class EmbreeSceneOf<HitTests>;
template class EmbreeSceneOf<Binary64Tests>;

}  // namespace artu::ref
