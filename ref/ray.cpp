#include "ref/ray.h"

#include <cmath>

namespace artu::ref {
namespace {

float component(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

// So that 0 * inverse is 0 and never NaN in the box test.
float inverse(float direction) {
  const float inv = 1.0f / direction;
  return std::fabs(inv) < 0x1p100f ? inv : std::copysign(0x1p100f, direction);
}

}  // namespace

Ray make_ray(const Vec3& origin, const Vec3& direction, float tmax) {
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.tmax = tmax;
  ray.inv = {inverse(direction.x), inverse(direction.y), inverse(direction.z)};

  ray.any_limited = false;
  for (int axis = 0; axis < 3; ++axis) {
    ray.limited[axis] = !(std::fabs(1.0f / component(direction, axis)) < 0x1p100f);
    ray.any_limited = ray.any_limited || ray.limited[axis];
  }

  const float ax = std::fabs(direction.x), ay = std::fabs(direction.y), az = std::fabs(direction.z);
  ray.kz = 0;
  if (ay > ax) ray.kz = 1;
  if (az > (ay > ax ? ay : ax)) ray.kz = 2;
  ray.kx = (ray.kz + 1) % 3;
  ray.ky = (ray.kz + 2) % 3;
  const float dz = component(direction, ray.kz);
  if (dz < 0) {  // keeps the winding, and with it the signs of U, V, W
    const int swap = ray.kx;
    ray.kx = ray.ky;
    ray.ky = swap;
  }
  ray.sx = component(direction, ray.kx) / dz;
  ray.sy = component(direction, ray.ky) / dz;
  ray.sz = 1.0f / dz;
  return ray;
}

template <class F>
Vector<F> camera_origin(const traces::Camera& camera, std::uint32_t x, std::uint32_t y) {
  const F fx = static_cast<F>(x) + F(0.5), fy = static_cast<F>(y) + F(0.5);
  return (camera.origin + Vector<F>(camera.origin_du) * fx) + Vector<F>(camera.origin_dv) * fy;
}

template <class F>
Vector<F> camera_direction(const traces::Camera& camera, std::uint32_t x, std::uint32_t y) {
  const F fx = static_cast<F>(x) + F(0.5), fy = static_cast<F>(y) + F(0.5);
  return unit((camera.corner + Vector<F>(camera.du) * fx) + Vector<F>(camera.dv) * fy);
}

template Vector<float> camera_origin<float>(const traces::Camera&, std::uint32_t, std::uint32_t);
template Vector<double> camera_origin<double>(const traces::Camera&, std::uint32_t, std::uint32_t);
template Vector<float> camera_direction<float>(const traces::Camera&, std::uint32_t, std::uint32_t);
template Vector<double> camera_direction<double>(const traces::Camera&, std::uint32_t, std::uint32_t);

}  // namespace artu::ref
