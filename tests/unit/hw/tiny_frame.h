// A whole frame laid down by hand: a floor, a moving triangle, sky, one light; and a unit that renders it.
#pragma once

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "hw/ray_tracing_unit.h"
#include "unit/hw/support.h"

namespace artu::hw::test {

struct TinyFrame {
  TinyFrame(std::uint32_t width, std::uint32_t height);
  FrameDescriptor& frame() { return image.at<FrameDescriptor>(descriptor); }
  const std::uint32_t width, height;
  MemoryImage image;
  Address descriptor = 0;
};

/// Everything that can be seen of a pixel.
using PixelTuple = std::tuple<int, int, int, int, int, int, int, int, int, int, std::int64_t, std::uint32_t>;

/// A unit with a SystemC context and a frame of its own.
struct TinyUnit {
  explicit TinyUnit(std::uint32_t width = 21, std::uint32_t height = 13, const RunMode& mode = {},
                    const UnitConfig& config = small(), const Fault& fault = {});
  static UnitConfig small();
  FrameResult run();
  std::vector<PixelTuple> pixels() const;
  std::uint64_t statistic(const FrameResult& result, const std::string& block, const std::string& name) const;

  SimulationContext context;
  TinyFrame tiny;
  PixelRecords records;
  RayTracingUnit unit;
};

}  // namespace artu::hw::test
