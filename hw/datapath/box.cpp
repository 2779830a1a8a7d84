#include "hw/datapath/box.h"

#include <limits>

namespace artu::hw {

void limited_slab(const Ray& ray, int axis, float lo, float hi, float& near, float& far) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  if ((ray.limited >> axis & 1) == 0) return;
  const float o = ray.origin[axis];
  if (lo <= o && o <= hi) {
    near = -infinity;
    far = infinity;
  } else if (ray.direction[axis] == 0) {
    near = infinity;
    far = -infinity;
  }
}

}  // namespace artu::hw
