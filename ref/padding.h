// How far Embree's boxes must be widened so that it never misses a candidate (docs/arithmetic.md section 9).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ref/precision.h"
#include "ref/triangle.h"

namespace artu::ref {

/// An axis-aligned box in binary64; empty as constructed.
struct Extent {
  std::array<double, 3> lo, hi;

  Extent();
  bool empty() const { return lo[0] > hi[0]; }
  void add(const std::array<double, 3>& point);
  void add(const Extent& other);
};

Extent extent_of(const std::vector<Triangle>& triangles);

/// Box of the origins of a frame's primary rays.
Extent camera_extent(const traces::Camera& camera, std::uint32_t width, std::uint32_t height);

/// 2^(2 - M) + 2^-17 of the distance between the farthest ray origin and the farthest corner of the geometry, in scene
/// units; M is the smaller one of the widths of the two tests.
double required_padding(const Extent& geometry, const Extent& camera, const Precision& precision = {});

}  // namespace artu::ref
