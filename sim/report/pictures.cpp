#include "sim/report/pictures.h"

#include "sim/report/heat.h"

namespace artu::sim {
namespace {

constexpr Color black{0, 0, 0};

template <class ColorOf>
Image paint(const FrameOutcome& outcome, ColorOf color_of) {
  Image image;
  image.width = outcome.width;
  image.height = outcome.height;
  image.rgb.reserve(outcome.pixels.size() * 3);
  for (const hw::PixelRecord& pixel : outcome.pixels) {
    const Color color = color_of(pixel);
    image.rgb.insert(image.rgb.end(), {color.r, color.g, color.b});
  }
  return image;
}

}  // namespace

Color decision_color(hw::Decision decision, hw::HitClass hit_class) {
  if (decision == hw::Decision::interpolated) return {24, 44, 84};
  // Sampling pixels are a regular grid: quiet greys, so that the traced candidates stand out.
  const bool sampled = decision == hw::Decision::sampled;
  switch (hit_class) {
    case hw::HitClass::static_geometry:
      return sampled ? Color{88, 88, 88} : Color{255, 176, 48};
    case hw::HitClass::dynamic_geometry:
      return sampled ? Color{136, 136, 136} : Color{232, 40, 72};
    default:
      return sampled ? Color{48, 48, 48} : Color{250, 240, 170};
  }
}

Color class_color(hw::HitClass hit_class) {
  switch (hit_class) {
    case hw::HitClass::miss:
      return {112, 112, 112};
    case hw::HitClass::static_geometry:
      return {64, 128, 208};
    case hw::HitClass::dynamic_geometry:
      return {232, 40, 72};
    default:
      return {0, 0, 0};
  }
}

Image frame_picture(const FrameOutcome& outcome) {
  return paint(outcome, [](const hw::PixelRecord& p) { return Color{p.r, p.g, p.b}; });
}

Image decision_picture(const FrameOutcome& outcome) {
  return paint(outcome, [](const hw::PixelRecord& p) { return decision_color(p.decision, p.hit_class); });
}

Image class_picture(const FrameOutcome& outcome) {
  return paint(outcome, [](const hw::PixelRecord& p) { return class_color(p.hit_class); });
}

Image threshold_picture(const FrameOutcome& outcome) {
  return paint(outcome, [](const hw::PixelRecord& p) { return p.threshold < 0 ? black : code_heat(p.threshold); });
}

Image difference_picture(const FrameOutcome& outcome) {
  return paint(outcome, [](const hw::PixelRecord& p) { return p.difference < 0 ? black : code_heat(p.difference); });
}

Image cycles_picture(const FrameOutcome& outcome) {
  return paint(outcome, [](const hw::PixelRecord& p) { return p.cycles == 0 ? black : cycles_heat(p.cycles); });
}

}  // namespace artu::sim
