#include "hw/datapath/box.h"

#include <limits>

namespace artu::hw {

Interval limited_box_interval(const Ray& ray, Vector lo, Vector hi) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  float near[3], far[3];
  for (int axis = 0; axis < 3; ++axis) {
    const float o = ray.origin[axis];
    const float a = (lo[axis] - o) * ray.inverse[axis], b = (hi[axis] - o) * ray.inverse[axis];
    near[axis] = minimum(a, b);
    far[axis] = maximum(a, b);
    if ((ray.limited >> axis & 1) == 0) continue;
    if (lo[axis] <= o && o <= hi[axis]) {
      near[axis] = -infinity;
      far[axis] = infinity;
    } else if (ray.direction[axis] == 0) {
      near[axis] = infinity;
      far[axis] = -infinity;
    }
  }
  return {maximum(maximum(near[0], near[1]), near[2]), minimum(minimum(far[0], far[1]), far[2]) * box_padding};
}

}  // namespace artu::hw
