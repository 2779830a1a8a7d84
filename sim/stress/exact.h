// The same ray and triangle without any rounding: how far off is the unit?
#pragma once

#include "hw/datapath/triangle.h"
#include "sim/stress/geometry.h"

namespace artu::sim {

/// From exact integers; every field is rounded once, at its end.
struct Exact {
  bool parallel = true;        // the ray lies in the plane, or there is none: nothing else is valid
  double a = 0, b = 0, c = 0;  // weights of the corners, below 0 outside
  double t = 0;
  // Of a computed hit:
  double t_ulps = 0;                // |t - exact| in units in the last place of t, in the triangle test's format
  double u_error = 0, v_error = 0;  // |U/det - a|, |V/det - b| in units of 2^-(M+1)
};

/// `hit` may be null; `triangle_bits` is M.
Exact exact_test(const hw::Ray& ray, const Corners& triangle, const hw::TriangleHit* hit,
                 int triangle_bits = hw::most_fraction_bits);

}  // namespace artu::sim
