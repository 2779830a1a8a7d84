// Frames of the unit against frames of the golden model, added up over a run.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ref/golden.h"
#include "sim/compare/pixel_compare.h"
#include "sim/driver/frame_outcome.h"

namespace artu::sim {

/// A pixel that differs, with all that both sides say of it.
struct PixelMismatch {
  std::uint32_t frame = 0, x = 0, y = 0;
  ref::Pixel golden;
  hw::PixelRecord unit;
};

struct RayMismatch {
  std::uint32_t frame = 0;
  const char* kind = "";
  std::uint64_t golden = 0, unit = 0;
};

struct CheckResult {
  std::uint64_t pixels = 0;            // compared
  std::uint64_t differing_pixels = 0;  // in one field or more
  std::array<std::uint64_t, pixel_field_count> differing_fields{};
  std::optional<PixelMismatch> first;  // in the order of frames, passes, rows, columns
  std::vector<RayMismatch> rays;
  double golden_seconds = 0, simulation_seconds = 0;

  bool passed() const { return differing_pixels == 0 && rays.empty(); }
};

/// Adds one frame to the result.  Throws std::logic_error where the two pictures have different sizes.
void compare_frame(const ref::Result& golden, const FrameOutcome& unit, CheckResult& result);

/// Adds the result of later frames.
void add(CheckResult& sum, const CheckResult& later);

/// One line if all is well, else the first mismatch and how often each field differs.
std::string describe(const CheckResult& result);

}  // namespace artu::sim
