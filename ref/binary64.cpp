#include "ref/binary64.h"

#include <chrono>

#include "ref/frame_geometry.h"
#include "ref/renderer_in.h"
#include "ref/selective.h"

namespace artu::ref {

struct Binary64::Impl {
  explicit Impl(const traces::Scene& scene_in) : scene(scene_in), geometry(scene, Binary64Tests()) {}

  const traces::Scene& scene;
  Settings settings;
  FrameGeometry<Binary64Tests> geometry;
};

Binary64::Binary64(const traces::Scene& scene, unsigned max_depth, float min_weight)
    : impl_(std::make_unique<Impl>(scene)) {
  impl_->settings.selective = false;
  impl_->settings.max_depth = max_depth;
  impl_->settings.min_weight = min_weight;
}

Binary64::~Binary64() = default;

Result Binary64::render(const traces::Frame& frame) const {
  const GeometryOf<Binary64Tests> geometry = impl_->geometry.build(frame);
  Result result;
  result.width = impl_->scene.width;
  result.height = impl_->scene.height;
  result.pixels.resize(static_cast<std::size_t>(result.width) * result.height);

  const auto start = std::chrono::steady_clock::now();
  RendererIn<double, Binary64Tests> renderer(impl_->scene, frame, impl_->settings, geometry);
  render_passes(impl_->settings, Image{result.width, result.height, result.pixels},
                [&](std::uint32_t x, std::uint32_t y, Pixel& pixel) { renderer.trace(x, y, pixel); });
  result.rays = renderer.rays();
  result.trace_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace artu::ref
