#include "ref/golden.h"

#include <chrono>

#include "ref/color.h"
#include "ref/geometry.h"
#include "ref/renderer.h"
#include "ref/selective.h"

namespace artu::ref {

struct Golden::Impl {
  Impl(const traces::Scene& scene_in, const Settings& settings_in)
      : scene(scene_in),
        settings(settings_in),
        tests(settings.precision),
        fixed(device, tests),
        dynamic(device, tests) {
    with_format(settings.precision.shading, [](auto) {});  // refuses a bad width now and not with the first frame
    fixed.set(scene.static_geometry, 0);
    srgb();  // before the first frame's clock runs
  }

  void build(const traces::Frame& frame);

  const traces::Scene& scene;
  const Settings settings;
  const EmbreeDevice device;  // before the scenes that live in it
  const HitTests tests;
  EmbreeScene fixed, dynamic;
};

void Golden::Impl::build(const traces::Frame& frame) {
  // Always anew: `dynamic_moved` speaks of the preceding frame, and frames may be rendered in any order.
  dynamic.set(frame.dynamic, static_cast<std::int64_t>(fixed.triangles().size()));
  Extent geometry = fixed.extent();
  geometry.add(dynamic.extent());
  const double padding =
      required_padding(geometry, camera_extent(frame.camera, scene.width, scene.height), settings.precision);
  dynamic.build(padding);
  // The static tree serves every frame whose padding does not exceed its own: more padding changes no result.  It is
  // built on the first frame, with room for a camera that moves a little, and again where a frame needs more or so much
  // less that the wide boxes would cost time.
  if (fixed.padding() < padding || fixed.padding() > 4 * padding) fixed.build(1.25 * padding);
}

Golden::Golden(const traces::Scene& scene, const Settings& settings) : impl_(std::make_unique<Impl>(scene, settings)) {}

Golden::~Golden() = default;

Result Golden::render(const traces::Frame& frame) const {
  impl_->build(frame);
  Result result;
  result.width = impl_->scene.width;
  result.height = impl_->scene.height;
  result.pixels.resize(static_cast<std::size_t>(result.width) * result.height);

  const auto start = std::chrono::steady_clock::now();
  const Geometry geometry{impl_->fixed, impl_->dynamic};
  const auto renderer = Renderer::make(impl_->scene, frame, impl_->settings, geometry);
  render_passes(impl_->settings, Image{result.width, result.height, result.pixels},
                [&](std::uint32_t x, std::uint32_t y, Pixel& pixel) { renderer->trace(x, y, pixel); });
  result.rays = renderer->rays();
  result.trace_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace artu::ref
