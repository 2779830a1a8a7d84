#include "sim/stress/accuracy.h"

#include <cmath>

#include "sim/stress/exact.h"

namespace artu::sim {
namespace {

/// The triangle as the ray sees it, in binary64: its heights, and how far away it is.
struct Projection {
  double height[3];
  double reach;  // the largest coordinate relative to the origin
};

Projection project(const hw::Ray& ray, const Corners& triangle) {
  double x[3], y[3];
  Projection out{};
  const double dz = ray.direction[ray.kz];
  for (int i = 0; i < 3; ++i) {
    const auto relative = [&](int axis) { return double(triangle[i][axis]) - double(ray.origin[axis]); };
    const double z = relative(ray.kz);
    x[i] = relative(ray.kx) - double(ray.direction[ray.kx]) / dz * z;
    y[i] = relative(ray.ky) - double(ray.direction[ray.ky]) / dz * z;
    for (int axis = 0; axis < 3; ++axis) out.reach = std::fmax(out.reach, std::fabs(relative(axis)));
  }
  const double area = std::fabs((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]));
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double edge = std::hypot(x[k] - x[j], y[k] - y[j]);
    out.height[i] = edge > 0 ? area / edge : 0;
  }
  return out;
}

void decide(const hw::Ray& ray, const Corners& triangle, const Exact& exact, bool hit, Scale scale, Accuracy& out) {
  if (exact.parallel) return;
  const double weight = std::fmin(std::fmin(exact.a, exact.b), exact.c);
  const double length = std::fabs(double(ray.direction[ray.kz]));
  const double margin = edge_margin * scale.size / length;
  const bool clear_inside = weight > edge_margin && exact.t > margin && exact.t < ray.tmax * (1 - edge_margin);
  const bool clear_outside = weight < -edge_margin || exact.t < -margin || exact.t > ray.tmax * (1 + edge_margin);
  if (!clear_inside && !clear_outside) return;
  out.decisions.add(hit != clear_inside);
  if (hit == clear_inside) return;
  // Three roundings for each sheared coordinate, and one for each difference from binary32: nearer than that, no test
  // of this format can know.
  const Projection p = project(ray, triangle);
  const double distance = std::fmin(std::fmin(exact.a * p.height[0], exact.b * p.height[1]), exact.c * p.height[2]);
  const int roundings = scale.triangle_bits == hw::most_fraction_bits ? 4 : 6;
  if (std::fabs(distance) < std::ldexp(roundings, -1 - scale.triangle_bits) * p.reach) ++out.explained;
}

}  // namespace

void measure_hit(const StressRay& ray, const Answer& answer, const Corners& triangle, Scale scale, Accuracy& out) {
  const Exact exact = exact_test(ray.ray, triangle, &answer.at, scale.triangle_bits);
  decide(ray.ray, triangle, exact, true, scale, out);
  if (exact.parallel || !(std::fmin(std::fmin(exact.a, exact.b), exact.c) > edge_margin)) return;
  out.t_ulps_all.add(exact.t_ulps);
  // Where the ray begins on the surface or runs along it, no number of places is worth stating; and the weights lose
  // what the origin's distance is longer than the triangle.
  if (ray.kind == RayKind::far || ray.kind == RayKind::surface || ray.kind == RayKind::grazing ||
      ray.kind == RayKind::along)
    return;
  const hw::Vector e1 = hw::unit(triangle[1] - triangle[0]), e2 = hw::unit(triangle[2] - triangle[0]);
  const hw::Vector normal =
      hw::unit(hw::Vector{e1.y * e2.z - e1.z * e2.y, e1.z * e2.x - e1.x * e2.z, e1.x * e2.y - e1.y * e2.x});
  if (std::fabs(hw::dot(normal, hw::unit(ray.ray.direction))) < 0.1f) return;
  if (exact.t * std::fabs(double(ray.ray.direction[ray.ray.kz])) < edge_margin * scale.size) return;
  out.t_ulps.add(exact.t_ulps);
  out.u.add(exact.u_error);
  out.v.add(exact.v_error);
}

void measure_decision(const hw::HitTests& tests, const hw::Ray& ray, const Corners& triangle, Scale scale,
                      Accuracy& out) {
  hw::TriangleHit hit;
  const bool found = tests.triangle(ray, triangle[0], triangle[1], triangle[2], hit);
  decide(ray, triangle, exact_test(ray, triangle, nullptr), found, scale, out);
}

}  // namespace artu::sim
