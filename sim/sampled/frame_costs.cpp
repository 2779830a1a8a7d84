#include "sim/sampled/frame_costs.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "hw/functional/functional_unit.h"
#include "sim/driver/image_builder.h"
#include "sim/driver/stack_check.h"

namespace artu::sim {

namespace {

hw::UnitConfig without_selective(hw::UnitConfig unit) {
  unit.selective.enabled = false;
  return unit;
}

std::uint32_t reduced(std::uint32_t edge) { return std::max(edge / FrameCosts::reduction, 1u); }

}  // namespace

struct FrameCosts::Impl {
  Impl(const traces::Scene& scene, const hw::UnitConfig& config, const SimulationOptions& options, FrameFrom frames)
      : name(scene.name),
        core(config.core),
        builder(scene, config, std::move(frames), image, options.static_trees),
        unit(without_selective(config), image) {}

  const std::string name;
  const hw::RayCoreConfig core;
  hw::MemoryImage image;
  ImageBuilder builder;
  const hw::FunctionalUnit unit;
  hw::PixelRecords records;
};

FrameCosts::FrameCosts(const traces::Scene& scene, const hw::UnitConfig& unit, const SimulationOptions& options,
                       FrameFrom frames)
    : impl_(std::make_unique<Impl>(scene, unit, options, std::move(frames))) {}

FrameCosts::~FrameCosts() = default;

FrameCosts::Look FrameCosts::at(const traces::Frame& frame) {
  Impl& impl = *impl_;
  const hw::Address address = impl.builder.add(frame);
  check_stack(impl.name, frame.index, impl.builder.stack_needed(), impl.core);
  // The same view with fewer pixels: those that lie in the middle of the larger ones.
  auto& descriptor = impl.image.at<hw::FrameDescriptor>(address);
  const auto across = static_cast<float>(descriptor.width) / static_cast<float>(reduced(descriptor.width));
  const auto down = static_cast<float>(descriptor.height) / static_cast<float>(reduced(descriptor.height));
  descriptor.width = reduced(descriptor.width);
  descriptor.height = reduced(descriptor.height);
  hw::CameraRegisters& camera = descriptor.camera;
  camera.du = camera.du * across;
  camera.origin_du = camera.origin_du * across;
  camera.dv = camera.dv * down;
  camera.origin_dv = camera.origin_dv * down;
  const std::size_t pixels = std::size_t{descriptor.width} * descriptor.height;
  impl.records.assign(pixels, {});
  const auto before = std::chrono::steady_clock::now();
  const hw::FunctionalCounts counts = impl.unit.run(address, impl.builder.stack_needed(), impl.records);
  const auto after = std::chrono::steady_clock::now();
  const std::uint64_t rays = std::accumulate(counts.rays.begin(), counts.rays.end(), std::uint64_t{0});
  const bool built = descriptor.dynamic_moved != 0 && descriptor.dynamic_triangle_count != 0;
  const FrameKind kind = !built                          ? FrameKind::nothing_built
                         : descriptor.dynamic_refit != 0 ? FrameKind::refitted
                                                         : FrameKind::built;
  return {{static_cast<double>(counts.nodes + counts.triangles + 2 * rays + 3 * pixels), kind},
          std::chrono::duration<double>(after - before).count()};
}

}  // namespace artu::sim
