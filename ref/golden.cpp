#include "ref/golden.h"

#include <chrono>

#include "ref/color.h"
#include "ref/frame_geometry.h"
#include "ref/renderer.h"
#include "ref/selective.h"

namespace artu::ref {

struct Golden::Impl {
  Impl(const traces::Scene& scene_in, const Settings& settings_in)
      : scene(scene_in), settings(settings_in), geometry(scene, HitTests(settings.precision)) {
    check(settings);
    with_format(settings.precision.shading, [](auto) {});  // refuses a bad width now and not with the first frame
    srgb();                                                // before the first frame's clock runs
  }

  const traces::Scene& scene;
  const Settings settings;
  FrameGeometry<HitTests> geometry;
};

Golden::Golden(const traces::Scene& scene, const Settings& settings) : impl_(std::make_unique<Impl>(scene, settings)) {}

Golden::~Golden() = default;

Result Golden::render(const traces::Frame& frame) const {
  const Geometry geometry = impl_->geometry.build(frame);
  Result result;
  result.width = impl_->scene.width;
  result.height = impl_->scene.height;
  result.pixels.resize(static_cast<std::size_t>(result.width) * result.height);

  const auto start = std::chrono::steady_clock::now();
  const auto renderer = Renderer::make(impl_->scene, frame, impl_->settings, geometry);
  render_passes(impl_->settings, Image{result.width, result.height, result.pixels},
                [&](std::uint32_t x, std::uint32_t y, Pixel& pixel) { renderer->trace(x, y, pixel); });
  result.rays = renderer->rays();
  result.trace_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace artu::ref
