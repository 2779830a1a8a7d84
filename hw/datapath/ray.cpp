#include "hw/datapath/ray.h"

namespace artu::hw {

Ray primary_ray(const CameraRegisters& camera, std::uint32_t x, std::uint32_t y) {
  const float fx = static_cast<float>(x) + 0.5f;
  const float fy = static_cast<float>(y) + 0.5f;
  Ray ray;
  ray.origin = (camera.origin + camera.origin_du * fx) + camera.origin_dv * fy;
  ray.direction = unit((camera.corner + camera.du * fx) + camera.dv * fy);
  return ray;
}

namespace {
float limited_inverse(float d) {
  const float inverse = 1.0f / d;
  return std::fabs(inverse) < two_pow_100 ? inverse : std::copysign(two_pow_100, d);
}
}  // namespace

void set_up(Ray& ray, int box_bits, int triangle_bits) {
  const Vector d = ray.direction;
  ray.inverse = {narrowed(limited_inverse(d.x), box_bits), narrowed(limited_inverse(d.y), box_bits),
                 narrowed(limited_inverse(d.z), box_bits)};
  ray.limited = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::fabs(1.0f / d[axis]) < two_pow_100)) ray.limited |= static_cast<std::uint8_t>(1 << axis);
  }
  int kz = 0;
  if (std::fabs(d.y) > std::fabs(d[kz])) kz = 1;
  if (std::fabs(d.z) > std::fabs(d[kz])) kz = 2;
  int kx = (kz + 1) % 3;
  int ky = (kz + 2) % 3;
  if (d[kz] < 0) {
    const int swapped = kx;
    kx = ky;
    ky = swapped;
  }
  ray.kx = static_cast<std::uint8_t>(kx);
  ray.ky = static_cast<std::uint8_t>(ky);
  ray.kz = static_cast<std::uint8_t>(kz);
  ray.sx = narrowed(d[kx] / d[kz], triangle_bits);
  ray.sy = narrowed(d[ky] / d[kz], triangle_bits);
  ray.sz = narrowed(1.0f / d[kz], triangle_bits);
}

}  // namespace artu::hw
