#include "sim/compare/full_render.h"

namespace artu::sim {
namespace {

template <class Source>
FullRender of(const Source& source) {
  FullRender full;
  full.image.width = source.width;
  full.image.height = source.height;
  full.image.rgb.reserve(source.pixels.size() * 3);
  for (const auto& pixel : source.pixels) {
    full.image.rgb.insert(full.image.rgb.end(), {pixel.r, pixel.g, pixel.b});
    full.classes.push_back(static_cast<hw::HitClass>(pixel.hit_class));
  }
  return full;
}

}  // namespace

FullRender full_render_of(const FrameOutcome& outcome) { return of(outcome); }
FullRender full_render_of(const ref::Result& golden) { return of(golden); }

}  // namespace artu::sim
