#include "hw/selective/candidate.h"

namespace artu::hw {
namespace {

Neighbour neighbour(const FrameDescriptor& frame, const MemoryImage& image, std::int64_t x, std::int64_t y) {
  if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) return {};
  const std::uint64_t index = static_cast<std::uint64_t>(y) * frame.pitch + static_cast<std::uint64_t>(x);
  const std::uint8_t* bytes = &image.at<std::uint8_t>(frame.frame_buffer + index * 4);
  const auto hit_class = static_cast<HitClass>(image.at<std::uint8_t>(frame.hit_classes + index));
  return {true, hit_class, {bytes[0], bytes[1], bytes[2]}};
}

}  // namespace

Candidate candidate_at(const FrameDescriptor& frame, const MemoryImage& image, const Pass& pass, std::uint32_t number,
                       std::uint32_t x, std::uint32_t y) {
  Candidate c;
  c.x = static_cast<std::uint16_t>(x);
  c.y = static_cast<std::uint16_t>(y);
  c.h = static_cast<std::uint8_t>(pass.h);
  c.kind = pass.kind;
  c.pass = static_cast<std::uint8_t>(number);
  const unsigned finished = pass.finished_neighbours();
  const std::int64_t h = pass.h;
  for (std::size_t i = 0; i < c.ring.size(); ++i) {
    if ((finished >> i & 1) == 0) continue;
    const auto place = static_cast<std::int64_t>(i < 4 ? i : i + 1);  // of 3 x 3
    c.ring[i] = neighbour(frame, image, x + (place % 3 - 1) * h, y + (place / 3 - 1) * h);
  }
  const auto compare = [&c](std::size_t first, std::size_t second) {
    if (!c.ring[first].finished || !c.ring[second].finished) return false;
    c.pairs.color[c.pairs.count++] = {c.ring[first].color, c.ring[second].color};
    return true;
  };
  const bool complete = (!pass.compares_rows() || compare(3, 4)) && (!pass.compares_columns() || compare(1, 6));
  if (!complete) c.pairs = {};
  return c;
}

void note_decision(const Candidate& candidate, int difference, Decision decision, PixelRecord& record) {
  record.pass = candidate.pass;
  record.n_static = candidate.counts.n_static;
  record.n_dynamic = candidate.counts.n_dynamic;
  record.threshold = candidate.threshold;
  record.difference = static_cast<std::int16_t>(difference);
  record.decision = decision;
}

void store_pixel(const FrameDescriptor& frame, MemoryImage& image, std::uint32_t x, std::uint32_t y, Rgb color,
                 HitClass hit_class) {
  const std::uint64_t index = std::uint64_t{y} * frame.pitch + x;
  std::uint8_t* bytes = &image.at<std::uint8_t>(frame.frame_buffer + index * 4);
  bytes[0] = color.r;
  bytes[1] = color.g;
  bytes[2] = color.b;
  bytes[3] = 255;
  image.at<std::uint8_t>(frame.hit_classes + index) = static_cast<std::uint8_t>(hit_class);
}

}  // namespace artu::hw
