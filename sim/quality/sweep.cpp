#include "sim/quality/sweep.h"
#include "sim/driver/frame_simulator.h"

#include <fmt/format.h>

#include <stdexcept>

#include "sim/energy/energy.h"
#include "sim/quality/baselines.h"
#include "sim/report/pictures.h"

namespace artu::sim {
namespace {

class Sweep {
 public:
  Sweep(const traces::Scene& scene, const QualityPlan& plan, const QualityHooks& hooks)
      : scene_(scene), plan_(plan), hooks_(hooks) {}

  std::vector<QualityRow> run() {
    std::vector<QualityRow> rows{full_row()};
    rows.push_back(baseline("low-resolution", low_resolution, low_resolution_pixels));
    rows.push_back(baseline("checkerboard", checkerboard, checkerboard_pixels));
    for (const QualityPoint& point : plan_.points) rows.push_back(row_of(point));
    return rows;
  }

 private:
  /// Simulates all frames, hands each to `take`, and fills in what they cost.
  template <class Take>
  void simulate(QualityRow& row, const hw::UnitConfig& unit, Take take);
  QualityRow full_row();
  QualityRow row_of(const QualityPoint& point);
  QualityRow baseline(const char* name, Image (*made)(const Image&),
                      std::uint64_t (*pixels)(std::uint32_t, std::uint32_t)) const;

  const traces::Scene& scene_;
  const QualityPlan& plan_;
  const QualityHooks& hooks_;
  std::vector<FullRender> full_;  // by frame
  std::uint64_t full_rays_ = 0;
};

template <class Take>
void Sweep::simulate(QualityRow& row, const hw::UnitConfig& unit, Take take) {
  const auto simulator = make_simulator(scene_, unit, {}, hooks_.frame_from);
  Totals sum;
  for (std::uint32_t index = plan_.first_frame; index < plan_.last_frame; ++index) {
    const FrameOutcome outcome = simulator->run(hooks_.frame(index));
    if (!outcome.violations.empty()) {
      throw std::logic_error(
          fmt::format("frame {}, {}: accounting law violated: {}", index, row.name(), outcome.violations[0]));
    }
    add(sum, totals_of(outcome));
    take(outcome, index - plan_.first_frame);
    hooks_.progress();
  }
  row.pixels = sum.pixels();
  row.traced = sum.sampled + sum.traced;
  row.rays = sum.rays();
  row.cycles = sum.cycles;
  row.dram_bytes = sum.dram_read_bytes + sum.dram_write_bytes;
  row.picojoules = energy_of(sum, unit).picojoules();
}

QualityRow Sweep::full_row() {
  QualityRow row;
  row.policy = "full";
  simulate(row, plan_.full, [&](const FrameOutcome& outcome, std::size_t) {
    full_.push_back(full_render_of(outcome));
    row.errors.add(full_.back(), full_.back().image);
  });
  full_rays_ = row.rays;
  return row;
}

QualityRow Sweep::row_of(const QualityPoint& point) {
  QualityRow row;
  row.policy = point.policy;
  row.reference = point.reference;
  row.shown = point.shown;
  row.attribution.emplace(plan_.worst, point.unit.selective.passes == hw::Passes::average);
  simulate(row, point.unit, [&](const FrameOutcome& outcome, std::size_t i) {
    row.errors.add(full_[i], frame_picture(outcome));
    row.attribution->add(full_[i], outcome);
    if (row.shown) hooks_.picture(row, outcome, full_[i]);
  });
  return row;
}

QualityRow Sweep::baseline(const char* name, Image (*made)(const Image&),
                           std::uint64_t (*pixels)(std::uint32_t, std::uint32_t)) const {
  QualityRow row;
  row.policy = name;
  for (const FullRender& full : full_) {
    row.errors.add(full, made(full.image));
    row.pixels += full.classes.size();
    row.traced += pixels(full.image.width, full.image.height);
  }
  // Rays of a pixel are not counted one by one: the full render's mean stands for them.
  row.rays = static_cast<std::uint64_t>(static_cast<double>(full_rays_) * row.traced_share() + 0.5);
  return row;
}

}  // namespace

std::string QualityRow::name() const { return reference ? fmt::format("{}-{}", policy, *reference) : policy; }

std::vector<QualityRow> run_quality(const traces::Scene& scene, const QualityPlan& plan, const QualityHooks& hooks) {
  return Sweep(scene, plan, hooks).run();
}

}  // namespace artu::sim
