#include "sim/compare/frame_compare.h"

#include <fmt/format.h>

#include <stdexcept>

namespace artu::sim {
namespace {

void compare_rays(const ref::RayCounts& golden, const FrameOutcome& unit, CheckResult& result) {
  const auto compare = [&](const char* kind, std::uint64_t g, std::uint64_t u) {
    if (g != u) result.rays.push_back({unit.index, kind, g, u});
  };
  compare("primary", golden.primary, unit.rays_primary);
  compare("shadow", golden.shadow, unit.rays_shadow);
  compare("reflection", golden.reflection, unit.rays_reflection);
  compare("refraction", golden.refraction, unit.rays_refraction);
}

}  // namespace

void compare_frame(const ref::Result& golden, const FrameOutcome& unit, CheckResult& result) {
  const std::uint64_t pixels = std::uint64_t{unit.width} * unit.height;
  if (golden.width != unit.width || golden.height != unit.height || golden.pixels.size() != pixels ||
      unit.pixels.size() != pixels) {
    throw std::logic_error(fmt::format("frame {}: the unit made {}x{} with {} pixels, the golden model {}x{} with {}",
                                       unit.index, unit.width, unit.height, unit.pixels.size(), golden.width,
                                       golden.height, golden.pixels.size()));
  }
  for (std::uint64_t i = 0; i < pixels; ++i) {
    const PixelFields fields = differing_fields(golden.pixels[i], unit.pixels[i]);
    if (fields.none()) continue;
    ++result.differing_pixels;
    for (std::size_t f = 0; f < pixel_field_count; ++f) result.differing_fields[f] += fields[f];
    // A fault in a pass shows in the passes after it too: the earliest pass has the cause.
    const bool earlier =
        !result.first || (result.first->frame == unit.index && golden.pixels[i].pass < result.first->golden.pass);
    if (earlier) {
      result.first = PixelMismatch{unit.index, static_cast<std::uint32_t>(i % unit.width),
                                   static_cast<std::uint32_t>(i / unit.width), golden.pixels[i], unit.pixels[i]};
    }
  }
  result.pixels += pixels;
  compare_rays(golden.rays, unit, result);
  result.golden_seconds += golden.trace_seconds;
  result.simulation_seconds += unit.simulation_seconds;
}

void add(CheckResult& sum, const CheckResult& later) {
  sum.pixels += later.pixels;
  sum.differing_pixels += later.differing_pixels;
  for (std::size_t f = 0; f < pixel_field_count; ++f) sum.differing_fields[f] += later.differing_fields[f];
  if (!sum.first) sum.first = later.first;
  sum.rays.insert(sum.rays.end(), later.rays.begin(), later.rays.end());
  sum.golden_seconds += later.golden_seconds;
  sum.simulation_seconds += later.simulation_seconds;
}

std::string describe(const CheckResult& result) {
  if (result.passed()) {
    return fmt::format(
        "check: {} pixels compared with the golden model, 0 differing; golden model {:.2f} s, "
        "simulation {:.2f} s\n",
        result.pixels, result.golden_seconds, result.simulation_seconds);
  }
  std::string out;
  if (result.first) {
    const PixelMismatch& m = *result.first;
    out += fmt::format("check: mismatch, first at frame {}, x {}, y {} (* = differs):\n", m.frame, m.x, m.y);
    out += comparison_table(m.golden, m.unit);
  }
  for (const RayMismatch& m : result.rays) {
    out += fmt::format("check: frame {}: {} rays: unit {}, golden {}\n", m.frame, m.kind, m.unit, m.golden);
  }
  out += fmt::format("check: {} of {} pixels differ", result.differing_pixels, result.pixels);
  const char* separator = " (";
  for (std::size_t f = 0; f < pixel_field_count; ++f) {
    if (result.differing_fields[f] == 0) continue;
    out += fmt::format("{}{} in {}", separator, field_name(static_cast<PixelField>(f)), result.differing_fields[f]);
    separator = ", ";
  }
  return out + (result.differing_pixels ? ")\n" : "\n");
}

}  // namespace artu::sim
