// Names of enumerators, as docs/selective-rendering.md has them.
#pragma once

#include "hw/pixel_record.h"

namespace artu::sim {

inline const char* class_name(hw::HitClass hit_class) {
  switch (hit_class) {
    case hw::HitClass::none:
      return "none";
    case hw::HitClass::miss:
      return "miss";
    case hw::HitClass::static_geometry:
      return "static";
    case hw::HitClass::dynamic_geometry:
      return "dynamic";
  }
  return "invalid";
}

inline const char* decision_name(hw::Decision decision) {
  switch (decision) {
    case hw::Decision::sampled:
      return "sampled";
    case hw::Decision::interpolated:
      return "interpolated";
    case hw::Decision::traced:
      return "traced";
  }
  return "invalid";
}

}  // namespace artu::sim
