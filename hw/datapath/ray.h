// A ray and its set-up for the box and the triangle test (docs/arithmetic.md section 2).
#pragma once

#include "hw/datapath/vector.h"

namespace artu::hw {

struct Ray {
  Vector origin, direction;
  float tmax = two_pow_100;  // tmin is 0
  // Set-up:
  Vector inverse;                // 1 / direction, limited to 2^100 in magnitude; in the box test's format
  float sx = 0, sy = 0, sz = 0;  // shear, in the triangle test's format
  std::uint8_t kx = 0, ky = 1, kz = 2;
  std::uint8_t limited = 0;  // axes (bits) whose inverse was limited: the ray is parallel to them, or nearly
};

/// The pixel ray's camera: see traces' camera, whose fields these are.
struct CameraRegisters {
  Vector origin, origin_du, origin_dv, corner, du, dv;
};

/// Origin and direction of the primary ray of pixel (x, y); the direction is zero for a dead ray.
Ray primary_ray(const CameraRegisters& camera, std::uint32_t x, std::uint32_t y);

/// Fills the set-up fields from origin and direction, which must not be dead, for box and triangle tests with so many
/// stored fraction bits.
void set_up(Ray& ray, int box_bits = most_fraction_bits, int triangle_bits = most_fraction_bits);

}  // namespace artu::hw
