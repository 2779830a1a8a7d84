// Embree's scenes of the frames of a trace: the static tree is kept from frame to frame.
#pragma once

#include "ref/geometry.h"

namespace artu::ref {

/// Tests is HitTests or Binary64Tests.
template <class Tests>
class FrameGeometry {
 public:
  /// `scene` must outlive it.
  FrameGeometry(const traces::Scene& scene, const Tests& tests)
      : scene_(scene), fixed_(device_, tests), dynamic_(device_, tests) {
    fixed_.set(scene.static_geometry, 0);
  }

  /// Of a frame of the scene, until the next call.
  GeometryOf<Tests> build(const traces::Frame& frame) {
    // Always anew: `dynamic_moved` speaks of the preceding frame, and frames may be rendered in any order.
    dynamic_.set(frame.dynamic, static_cast<std::int64_t>(fixed_.triangles().size()));
    Extent geometry = fixed_.extent();
    geometry.add(dynamic_.extent());
    const double padding = fixed_.tests().padding(geometry, camera_extent(frame.camera, scene_.width, scene_.height));
    dynamic_.build(padding);
    // The static tree serves every frame whose padding does not exceed its own: more padding changes no result.  It is
    // built on the first frame, with room for a camera that moves a little, and again where a frame needs more or so
    // much less that the wide boxes would cost time.
    if (fixed_.padding() < padding || fixed_.padding() > 4 * padding) fixed_.build(1.25 * padding);
    return {fixed_, dynamic_};
  }

 private:
  const traces::Scene& scene_;
  const EmbreeDevice device_;  // before the scenes that live in it
  EmbreeSceneOf<Tests> fixed_, dynamic_;
};

}  // namespace artu::ref
