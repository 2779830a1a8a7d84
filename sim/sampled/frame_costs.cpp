#include "sim/sampled/frame_costs.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>
#include <utility>

#include "hw/frame_registers.h"
#include "hw/functional/functional_unit.h"
#include "hw/memory/build_plan.h"
#include "sim/driver/image_builder.h"
#include "sim/driver/stack_check.h"
#include "sim/report/digest.h"
#include "traces/pack.h"

namespace artu::sim {

namespace {

hw::UnitConfig without_selective(hw::UnitConfig unit) {
  unit.selective.enabled = false;
  return unit;
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point before) { return std::chrono::duration<double>(Clock::now() - before).count(); }

/// Of all that is in a frame but its index and time.
FrameDigest digest_of(traces::Frame& frame) {
  const std::uint32_t index = std::exchange(frame.index, 0);
  const double time = std::exchange(frame.time, 0);
  std::string parts;
  traces::pack(frame, [&](const std::uint8_t* data, std::size_t size) {
    parts += sha256_of({reinterpret_cast<const char*>(data), size});
  });
  frame.index = index;
  frame.time = time;
  const std::string whole = sha256_of(parts);
  FrameDigest digest{};
  std::copy(whole.begin(), whole.end(), digest.begin());
  return digest;
}

/// What the tree builder computes for the frame, in cycles; what it waits for the memory is not in it.
double build_cycles(const hw::UnitConfig& config, const hw::FrameDescriptor& frame) {
  double cycles = 0;
  if (!hw::builds(frame, config.skip)) return cycles;
  for (const hw::BuildStep& step : hw::plan_build(config.tree_builder, frame)) {
    cycles += static_cast<double>(step.compute);
  }
  return cycles;
}

std::uint32_t reduced(std::uint32_t edge) { return std::max(edge / FrameCosts::reduction, 1u); }

/// The same view with fewer pixels: those that lie in the middle of the larger ones.
void reduce(hw::FrameDescriptor& frame) {
  const auto across = static_cast<float>(frame.width) / static_cast<float>(reduced(frame.width));
  const auto down = static_cast<float>(frame.height) / static_cast<float>(reduced(frame.height));
  frame.width = reduced(frame.width);
  frame.height = reduced(frame.height);
  hw::CameraRegisters& camera = frame.camera;
  camera.du = camera.du * across;
  camera.origin_du = camera.origin_du * across;
  camera.dv = camera.dv * down;
  camera.origin_dv = camera.origin_dv * down;
}

}  // namespace

struct FrameCosts::Impl {
  Impl(const traces::Scene& scene, const hw::UnitConfig& config, const SimulationOptions& options, FrameFrom frames)
      : name(scene.name),
        config(config),
        builder(scene, config, std::move(frames), image, options.static_trees),
        unit(without_selective(config), image) {}

  const std::string name;
  const hw::UnitConfig config;
  hw::MemoryImage image;
  ImageBuilder builder;
  const hw::FunctionalUnit unit;
  hw::PixelRecords records;
  std::map<FrameDigest, FrameCost> known;
};

FrameCosts::FrameCosts(const traces::Scene& scene, const hw::UnitConfig& unit, const SimulationOptions& options,
                       FrameFrom frames)
    : impl_(std::make_unique<Impl>(scene, unit, options, std::move(frames))) {}

FrameCosts::~FrameCosts() = default;

FrameCosts::Look FrameCosts::at(traces::Frame frame) {
  Impl& impl = *impl_;
  const auto begin = Clock::now();
  FrameDigest digest{};
  if (!impl.config.tree_builder.refit) digest = digest_of(frame);
  if (const auto it = impl.known.find(digest); it != impl.known.end()) return {it->second, seconds_since(begin)};
  const double digest_seconds = seconds_since(begin);
  const hw::Address address = impl.builder.add(frame);
  check_stack(impl.name, frame.index, impl.builder.stack_needed(), impl.config.core);
  auto& descriptor = impl.image.at<hw::FrameDescriptor>(address);
  const double all_pixels = static_cast<double>(descriptor.width) * descriptor.height;
  reduce(descriptor);
  const std::size_t pixels = std::size_t{descriptor.width} * descriptor.height;
  impl.records.assign(pixels, {});
  const auto before = Clock::now();
  const double build = build_cycles(impl.config, descriptor);
  const hw::FunctionalCounts counts = impl.unit.run(address, impl.builder.stack_needed(), impl.records);
  const double seconds = digest_seconds + seconds_since(before);
  const std::uint64_t rays = std::accumulate(counts.rays.begin(), counts.rays.end(), std::uint64_t{0});
  const bool built = hw::builds(descriptor, impl.config.skip);
  const FrameKind kind = !built                          ? FrameKind::nothing_built
                         : descriptor.dynamic_refit != 0 ? FrameKind::refitted
                                                         : FrameKind::built;
  const auto work = static_cast<double>(counts.nodes + counts.triangles + 2 * rays + 3 * pixels);
  // Of the whole picture, shared out to the cores: cycles, more or less, as those of the build are.
  const double traced = work * all_pixels / static_cast<double>(pixels) / impl.config.core.count;
  const FrameCost cost{build + traced, kind, digest};
  if (digest != FrameDigest{}) impl.known.emplace(digest, cost);
  return {cost, seconds};
}

}  // namespace artu::sim
