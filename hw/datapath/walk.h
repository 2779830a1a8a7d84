// A whole traversal as a function: what the ray core's traversal and intersection find, without time.
#pragma once

#include "hw/datapath/hit_tests.h"
#include "hw/memory/image.h"

namespace artu::hw {

struct Found {
  bool hit = false, dynamic = false;
  TriangleHit best;
  std::uint32_t primitive = 0;  // global id
  std::uint32_t triangle = 0;   // index of its record
};

struct WalkCounts {
  std::uint64_t nodes = 0, boxes = 0, triangles = 0;
};

/// Keeps the nearer of two hits; on equal t the one with the smaller primitive id (docs/arithmetic.md section 3).
inline void consider(const TriangleHit& hit, std::uint32_t primitive, std::uint32_t triangle, bool dynamic,
                     Found& found) {
  if (found.hit && !nearer(hit, primitive, found.best, found.primitive)) return;
  found = {true, dynamic, hit, primitive, triangle};
}

/// Closest hit of a ray that `tests` has set up, or with `any` the first that is found.
Found walk(const HitTests& tests, const FrameDescriptor& frame, const MemoryImage& image, const Ray& ray, bool any,
           WalkCounts* counts = nullptr);

}  // namespace artu::hw
