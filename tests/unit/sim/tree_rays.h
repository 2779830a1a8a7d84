// Rays that are hard on a tree: through vertices and edges, along planes, from planes, with zero components.
#pragma once

#include "tree_support.h"

namespace artu::sim::test {

class RaySource {
 public:
  /// `planes`: coordinates by axis from which rays may start; the mesh's vertices are used as well.
  RaySource(const traces::Mesh& mesh, const std::vector<float> (&planes)[3], hw::Vector lo, hw::Vector hi,
            std::uint32_t seed)
      : mesh_(mesh), planes_(planes), lo_(lo), hi_(hi), random_(seed) {
    extent_ = std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z, 0x1p-149f});
  }

  /// A ray that is set up, never dead.
  hw::Ray next() {
    hw::Ray ray;
    do {
      const hw::Vector target = random_.one_in(4) ? on_planes(on_mesh()) : on_mesh();
      if (random_.one_in(2)) {
        ray.origin = origin();
        ray.direction = target - ray.origin;
        if (random_.one_in(4)) ray.direction = with(ray.direction, axis(), zero());
        ray.tmax = random_.one_in(2) ? 1 : hw::two_pow_100;
        if (random_.one_in(2)) normalise(ray);
      } else {
        ray.direction = direction();
        if (random_.one_in(2)) normalise(ray);
        const float back = random_.one_in(4) ? 0 : random_.in(-2, 10) * extent_ / largest(ray.direction);
        ray.origin = target - ray.direction * back;
        if (!std::isfinite(ray.origin.x + ray.origin.y + ray.origin.z)) ray.origin = target;
      }
    } while (is_zero(ray.direction));
    set_up(ray);
    return ray;
  }

 private:
  static float largest(hw::Vector v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z), 0x1p-149f}); }
  static hw::Vector with(hw::Vector v, int axis, float value) {
    (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value;
    return v;
  }
  int axis() { return static_cast<int>(random_.below(3)); }
  float zero() { return random_.one_in(2) ? 0.0f : -0.0f; }

  void normalise(hw::Ray& ray) {
    const double x = ray.direction.x, y = ray.direction.y, z = ray.direction.z, l = std::sqrt(x * x + y * y + z * z);
    if (!(l > 0)) return;
    ray.direction = {static_cast<float>(x / l), static_cast<float>(y / l), static_cast<float>(z / l)};
    ray.tmax = hw::two_pow_100;
  }

  /// A vertex, a point of an edge or of the interior.
  hw::Vector on_mesh() {
    const std::size_t triangle = random_.below(mesh_.triangle_count()), first = random_.below(3);
    const hw::Vector a = vertex(mesh_, triangle, first), b = vertex(mesh_, triangle, (first + 1) % 3),
                     c = vertex(mesh_, triangle, (first + 2) % 3);
    const float u = random_.in(0, 1), v = random_.in(0, 1) * (1 - u);
    switch (random_.below(4)) {
      case 0:
        return a;
      case 1:
        return a * u + b * (1 - u);
      case 2:
        return (a + b) * 0.5f;
      default:
        return (a * u + b * v) + c * ((1 - u) - v);
    }
  }

  /// The point, moved along one axis or more to a plane of a tree or a vertex.
  hw::Vector on_planes(hw::Vector point) {
    do {
      const int on = axis();
      const std::vector<float>& planes = planes_[on];
      const bool vertices = planes.empty() || random_.one_in(3);
      const float to = vertices ? vertex(mesh_, random_.below(mesh_.triangle_count()), random_.below(3))[on]
                                : planes[random_.below(planes.size())];
      point = with(point, on, to);
    } while (random_.one_in(2));
    return point;
  }

  hw::Vector origin() {
    const hw::Vector middle = lo_ * 0.5f + hi_ * 0.5f;
    const hw::Vector inside{random_.in(lo_.x, hi_.x), random_.in(lo_.y, hi_.y), random_.in(lo_.z, hi_.z)};
    switch (random_.below(6)) {
      case 0:
        return middle + random_.in_cube(2) * extent_;
      case 1:
        return middle + random_.in_cube(1) * (extent_ * (random_.one_in(2) ? 1e3f : 30.0f));
      case 2:
        return inside;
      case 3:
        return on_planes(inside);
      case 4:
        return on_planes(middle + random_.in_cube(2) * extent_);
      default:
        return on_mesh();
    }
  }

  hw::Vector direction() {
    const std::size_t triangle = random_.below(mesh_.triangle_count());
    const hw::Vector a = vertex(mesh_, triangle, 0), b = vertex(mesh_, triangle, 1), c = vertex(mesh_, triangle, 2);
    const float sign = random_.one_in(2) ? 1.0f : -1.0f;
    switch (random_.below(7)) {
      case 0:
        return with({zero(), zero(), zero()}, axis(), sign);  // along an axis
      case 1:
        return with(random_.in_cube(1), axis(), zero());  // in a plane across an axis
      case 2:
        return (b - a) * sign;  // along an edge
      case 3:
        return (b - a) * random_.in(-1, 1) + (c - a) * random_.in(-1, 1);  // grazing
      case 4:  // all but in a plane across an axis: the inverse is limited, or large
        return with(random_.in_cube(1), axis(), sign * std::ldexp(1.0f, -20 - static_cast<int>(random_.below(129))));
      case 5: {  // a diagonal, through the corners of grids
        const auto one = [&] { return static_cast<float>(random_.below(3)) - 1; };
        return {one(), one(), one()};
      }
      default:
        return random_.in_cube(1);
    }
  }

  const traces::Mesh& mesh_;
  const std::vector<float> (&planes_)[3];
  const hw::Vector lo_, hi_;
  Random random_;
  float extent_;
};

}  // namespace artu::sim::test
