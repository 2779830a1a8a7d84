#include "ref/binary64_tests.h"

#include <cmath>
#include <utility>

namespace artu::ref {
namespace {

double component(const Vector<double>& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// a * b - c * d, 0 or of the right sign.
///
/// Rounding is monotone: fl(ab) > fl(cd) only if ab > cd, and then what the products lack, which fma gives exactly,
/// differs by no less than -(fl(ab) - fl(cd)), rounded or not: the sum does not pass 0.
double difference_of_products(double a, double b, double c, double d) {
  const double ab = a * b, cd = c * d;
  return (ab - cd) + (std::fma(a, b, -ab) - std::fma(c, d, -cd));
}

}  // namespace

Binary64Ray Binary64Tests::ray(const Vector<double>& origin, const Vector<double>& direction, double tmax) const {
  Binary64Ray ray{origin, direction, tmax, 0, 0, 0, 0, 0, 0};
  const double ax = std::fabs(direction.x), ay = std::fabs(direction.y), az = std::fabs(direction.z);
  if (ay > ax) ray.kz = 1;
  if (az > max(ax, ay)) ray.kz = 2;
  ray.kx = (ray.kz + 1) % 3;
  ray.ky = (ray.kz + 2) % 3;
  const double dz = component(direction, ray.kz);
  if (dz < 0) std::swap(ray.kx, ray.ky);  // keeps the winding
  ray.sx = component(direction, ray.kx) / dz;
  ray.sy = component(direction, ray.ky) / dz;
  ray.sz = 1 / dz;
  return ray;
}

bool Binary64Tests::intersect(const Ray& ray, const Triangle& triangle, TriangleHitIn<double>& hit) const {
  const auto& p = triangle.v;
  const double ox = component(ray.origin, ray.kx), oy = component(ray.origin, ray.ky),
               oz = component(ray.origin, ray.kz);
  double x[3], y[3], z[3];  // of the corners, sheared so that the ray runs along z
  for (int i = 0; i < 3; ++i) {
    z[i] = p[3 * i + ray.kz] - oz;
    x[i] = (p[3 * i + ray.kx] - ox) - ray.sx * z[i];
    y[i] = (p[3 * i + ray.ky] - oy) - ray.sy * z[i];
  }
  const double u = difference_of_products(x[2], y[1], y[2], x[1]);
  const double v = difference_of_products(x[0], y[2], y[0], x[2]);
  const double w = difference_of_products(x[1], y[0], y[1], x[0]);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
  const double det = (u + v) + w;
  if (det == 0) return false;
  const double t = ray.sz * ((u * z[0] + v * z[1]) + w * z[2]) / det;
  if (!(0 <= t && t <= ray.tmax)) return false;  // false for a NaN too
  hit = {t, u, v, det};
  return true;
}

double Binary64Tests::padding(const Extent& geometry, const Extent& camera) const {
  if (geometry.empty()) return 0;
  Extent all = geometry;
  all.add(camera);
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::fmax(largest, std::fmax(std::fabs(all.lo[i]), std::fabs(all.hi[i])));
  return required_padding(geometry, camera) + 0x1p-22 * largest;
}

}  // namespace artu::ref
