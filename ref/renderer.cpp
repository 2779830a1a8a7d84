#include "ref/renderer_in.h"

namespace artu::ref {

std::unique_ptr<Renderer> Renderer::make(const traces::Scene& scene, const traces::Frame& frame,
                                         const Settings& settings, const Geometry& geometry, bool emulate) {
  const auto in = [&](auto format) -> std::unique_ptr<Renderer> {
    return std::make_unique<RendererIn<typename decltype(format)::Type, HitTests>>(scene, frame, settings, geometry);
  };
  return emulate ? with_number(settings.precision.shading, in) : with_format(settings.precision.shading, in);
}

}  // namespace artu::ref
