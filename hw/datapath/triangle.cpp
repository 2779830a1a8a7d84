#include "hw/datapath/triangle.h"

#include "hw/datapath/box.h"

namespace artu::hw {

namespace {
/// Both products are exact in binary64: the sign of the difference is right, and one rounding follows.
float difference_of_products(float a, float b, float c, float d) {
  return static_cast<float>(static_cast<double>(a) * static_cast<double>(b) -
                            static_cast<double>(c) * static_cast<double>(d));
}

Vector lowest(Vector a, Vector b, Vector c) {
  return {minimum(minimum(a.x, b.x), c.x), minimum(minimum(a.y, b.y), c.y), minimum(minimum(a.z, b.z), c.z)};
}

Vector highest(Vector a, Vector b, Vector c) {
  return {maximum(maximum(a.x, b.x), c.x), maximum(maximum(a.y, b.y), c.y), maximum(maximum(a.z, b.z), c.z)};
}
}  // namespace

bool intersect(const Ray& ray, Vector a, Vector b, Vector c, TriangleHit& hit) {
  const Vector ta = a - ray.origin, tb = b - ray.origin, tc = c - ray.origin;
  const float ax = ta[ray.kx] - ray.sx * ta[ray.kz], ay = ta[ray.ky] - ray.sy * ta[ray.kz];
  const float bx = tb[ray.kx] - ray.sx * tb[ray.kz], by = tb[ray.ky] - ray.sy * tb[ray.kz];
  const float cx = tc[ray.kx] - ray.sx * tc[ray.kz], cy = tc[ray.ky] - ray.sy * tc[ray.kz];
  const float U = difference_of_products(cx, by, cy, bx);
  const float V = difference_of_products(ax, cy, ay, cx);
  const float W = difference_of_products(bx, ay, by, ax);
  if ((U < 0 || V < 0 || W < 0) && (U > 0 || V > 0 || W > 0)) return false;
  const float det = (U + V) + W;
  if (det == 0) return false;
  const float az = ray.sz * ta[ray.kz], bz = ray.sz * tb[ray.kz], cz = ray.sz * tc[ray.kz];
  float t = ((U * az + V * bz) + W * cz) / det;
  if (t != t) return false;
  const Interval box = box_interval(ray, lowest(a, b, c), highest(a, b, c));
  if (box.enter > box.exit) return false;
  t = minimum(maximum(t, box.enter), box.exit);
  if (!(0.0f <= t && t <= ray.tmax)) return false;
  hit = {t, U, V, det};
  return true;
}

}  // namespace artu::hw
