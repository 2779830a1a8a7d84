#include "sim/report/picture_set.h"

#include <fmt/format.h>

#include <stdexcept>

#include "sim/report/heat.h"
#include "sim/report/legend.h"
#include "sim/report/pictures.h"

namespace artu::sim {
namespace {

using hw::Decision;
using hw::HitClass;

constexpr Color black{0, 0, 0};

Legend decision_legend() {
  const auto entry = [](const char* text, Decision decision, HitClass hit_class) {
    return Legend::Entry{decision_color(decision, hit_class), text};
  };
  return {"decision",
          {entry("interpolated", Decision::interpolated, HitClass::none),
           entry("traced: dynamic", Decision::traced, HitClass::dynamic_geometry),
           entry("traced: static", Decision::traced, HitClass::static_geometry),
           entry("traced: nothing", Decision::traced, HitClass::miss),
           entry("sampled: dynamic", Decision::sampled, HitClass::dynamic_geometry),
           entry("sampled: static", Decision::sampled, HitClass::static_geometry),
           entry("sampled: nothing", Decision::sampled, HitClass::miss)}};
}

Legend class_legend() {
  return {"ray hit",
          {{class_color(HitClass::dynamic_geometry), "dynamic"},
           {class_color(HitClass::static_geometry), "static"},
           {class_color(HitClass::miss), "nothing"},
           {class_color(HitClass::none), "not traced"}}};
}

Legend code_legend(const char* title) {
  Legend legend{title, {{black, "none"}}};
  for (const int code : {0, 1, 3, 7, 15, 31, 63, 127, 255}) {
    legend.entries.push_back({code_heat(code), fmt::format("{}", code)});
  }
  return legend;
}

Legend error_legend() {
  Legend legend{"error", {{black, "equal"}}};
  for (const int d : {1, 4, 16, 64, 255}) legend.entries.push_back({error_heat(d), fmt::format("{}", d)});
  return legend;
}

Legend cycles_legend() {
  Legend legend{"cycles", {{black, "not traced"}}};
  for (const std::uint32_t c : {100u, 320u, 1000u, 3200u, 10000u}) {
    legend.entries.push_back({cycles_heat(c), fmt::format("{}", c)});
  }
  return legend;
}

Image beside(std::initializer_list<Picture> pictures, const FrameOutcome& outcome, const FullRender* full) {
  std::vector<Image> panels;
  for (const Picture picture : pictures) {
    const Image panel = picture_of(picture, outcome, full);
    const bool named = picture != Picture::frame && picture != Picture::full;
    panels.push_back(named ? panel : with_legend(panel, {picture_names[static_cast<std::size_t>(picture)], {}}));
  }
  return side_by_side(panels);
}

}  // namespace

bool PictureSet::needs_full() const {
  return has(Picture::full) || has(Picture::error) || has(Picture::strip) || has(Picture::animation);
}

Image picture_of(Picture picture, const FrameOutcome& outcome, const FullRender* full) {
  switch (picture) {
    case Picture::frame:
      return frame_picture(outcome);
    case Picture::full:
      return full->image;
    case Picture::decision:
      return with_legend(decision_picture(outcome), decision_legend());
    case Picture::hit_class:
      return with_legend(class_picture(outcome), class_legend());
    case Picture::threshold:
      return with_legend(threshold_picture(outcome), code_legend("threshold"));
    case Picture::difference:
      return with_legend(difference_picture(outcome), code_legend("difference"));
    case Picture::error:
      return with_legend(heat_map(frame_picture(outcome), full->image), error_legend());
    case Picture::cycles:
      return with_legend(cycles_picture(outcome), cycles_legend());
    case Picture::strip:
      return beside({Picture::frame, Picture::full, Picture::error, Picture::decision, Picture::threshold}, outcome,
                    full);
    case Picture::animation:
      return beside({Picture::frame, Picture::error, Picture::decision}, outcome, full);
  }
  throw std::logic_error("no such picture");
}

PictureWriter::PictureWriter(const std::string& prefix, const PictureSet& set, std::uint32_t frames, double fps)
    : prefix_(prefix), set_(set) {
  if (set_.has(Picture::animation)) {
    animation_ = std::make_unique<AnimatedPng>(prefix_ + "animation.png", frames, fps);
  }
}

std::string PictureWriter::write(const FrameOutcome& outcome, const FullRender* full) const {
  std::string part;
  for (std::size_t i = 0; i < picture_count; ++i) {
    const auto picture = static_cast<Picture>(i);
    if (!set_.has(picture)) continue;
    const Image image = picture_of(picture, outcome, full);
    if (picture == Picture::animation) {
      part = encode_png(prefix_ + "animation.png", image);
    } else {
      write_png(fmt::format("{}{}_{:04}.png", prefix_, picture_names[i], outcome.index), image);
    }
  }
  return part;
}

void PictureWriter::append(const std::string& part) {
  if (animation_) animation_->add(part);
}

void PictureWriter::finish() {
  if (animation_) animation_->close();
}

}  // namespace artu::sim
