// Names of enumerators, as docs/selective-rendering.md and docs/trees.md have them.
#pragma once

#include "hw/pixel_record.h"
#include "hw/unit_config.h"

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

inline constexpr hw::TreeKind all_trees[] = {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8,
                                             hw::TreeKind::kd};

inline const char* tree_name(hw::TreeKind kind) {
  switch (kind) {
    case hw::TreeKind::bvh2:
      return "bvh2";
    case hw::TreeKind::bvh4:
      return "bvh4";
    case hw::TreeKind::bvh8:
      return "bvh8";
    case hw::TreeKind::kd:
      return "kd";
  }
  return "invalid";
}

}  // namespace artu::sim
