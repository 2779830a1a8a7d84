// What is read and written of the frame's memory for a candidate, and the rule that decides on it: shared by the blocks
// and the functional model.
#pragma once

#include "hw/memory/image.h"
#include "hw/selective/pass_plan.h"
#include "hw/selective/tokens.h"

namespace artu::hw {

/// A candidate of pass `number` with its neighbours, as the frame buffer and the hit-class map in memory have them.
Candidate candidate_at(const FrameDescriptor& frame, const MemoryImage& image, const Pass& pass, std::uint32_t number,
                       std::uint32_t x, std::uint32_t y);

/// Interpolated if there is a pair and it differs by no more than the threshold; else traced.  Of a centre the sums of
/// its two pairs are compared instead of their means.
inline bool is_interpolated(const Pairs& pairs, int difference, std::uint8_t threshold) {
  return pairs.count != 0 && difference <= pairs.count * threshold;
}

/// Columns of the record that a decision fills.
void note_decision(const Candidate& candidate, int difference, Decision decision, PixelRecord& record);

/// Lays a finished pixel down in frame buffer and hit-class map.
void store_pixel(const FrameDescriptor& frame, MemoryImage& image, std::uint32_t x, std::uint32_t y, Rgb color,
                 HitClass hit_class);

}  // namespace artu::hw
