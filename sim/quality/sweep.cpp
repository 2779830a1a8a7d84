#include "sim/quality/sweep.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "sim/driver/frame_simulator.h"
#include "sim/energy/energy.h"
#include "sim/jobs/processes.h"
#include "sim/jobs/results.h"
#include "sim/quality/baselines.h"
#include "sim/report/pictures.h"

namespace artu::sim {
namespace {

/// What one frame of a row gives.
struct FrameResult {
  Totals totals;
  Errors errors;
  FullRender full;                         // of the full render's row
  std::optional<Attribution> attribution;  // of a point
  std::string part;                        // of the pictures
};

template <class A>
void transfer(A& archive, FrameResult& r) {
  pass_all(archive, r.totals, r.errors, r.full, r.attribution, r.part);
}

class Sweep {
 public:
  Sweep(const traces::Scene& scene, const QualityPlan& plan, const QualityHooks& hooks)
      : scene_(scene), plan_(plan), hooks_(hooks), trees_(scene) {}

  std::vector<QualityRow> run() {
    std::vector<QualityRow> rows{full_row()};
    rows.push_back(baseline("low-resolution", low_resolution, low_resolution_pixels));
    rows.push_back(baseline("checkerboard", checkerboard, checkerboard_pixels));
    for (QualityRow& row : point_rows()) rows.push_back(std::move(row));
    return rows;
  }

 private:
  /// Simulates a frame; throws where an accounting law is violated.
  FrameOutcome simulate(const QualityRow& row, const hw::UnitConfig& unit, std::size_t frame);
  QualityRow full_row();
  std::vector<QualityRow> point_rows();
  FrameResult frame_of(const QualityPoint& point, const QualityRow& row, std::size_t frame);
  QualityRow baseline(const char* name, Image (*made)(const Image&),
                      std::uint64_t (*pixels)(std::uint32_t, std::uint32_t)) const;

  const traces::Scene& scene_;
  const QualityPlan& plan_;
  const QualityHooks& hooks_;
  StaticTrees trees_;
  const hw::UnitConfig* present_ = nullptr;  // the frames of a unit come one after the other
  std::unique_ptr<FrameSimulator> simulator_;
  std::vector<FullRender> full_;  // by frame
  std::uint64_t full_rays_ = 0;
};

/// What the frames cost.
void fill_in(QualityRow& row, const Totals& sum, const hw::UnitConfig& unit) {
  row.pixels = sum.pixels();
  row.traced = sum.sampled + sum.traced;
  row.rays = sum.rays();
  row.cycles = sum.cycles;
  row.dram_bytes = sum.dram_read_bytes + sum.dram_write_bytes;
  row.picojoules = energy_of(sum, unit).picojoules();
}

FrameOutcome Sweep::simulate(const QualityRow& row, const hw::UnitConfig& unit, std::size_t frame) {
  if (present_ != &unit) {
    SimulationOptions options;
    options.static_trees = &trees_;
    simulator_.reset();
    simulator_ = make_simulator(scene_, unit, options, hooks_.frame_from);
    present_ = &unit;
  }
  const std::uint32_t index = plan_.first_frame + static_cast<std::uint32_t>(frame);
  FrameOutcome outcome = simulator_->run(hooks_.frame(index));
  if (!outcome.violations.empty()) {
    throw std::logic_error(
        fmt::format("frame {}, {}: accounting law violated: {}", index, row.name(), outcome.violations[0]));
  }
  return outcome;
}

QualityRow Sweep::full_row() {
  QualityRow row;
  row.policy = "full";
  Totals sum;
  trees_.of(plan_.full.accel);
  in_order<FrameResult>(
      plan_.frames(), plan_.jobs,
      [&](std::uint64_t frame) {
        const FrameOutcome outcome = simulate(row, plan_.full, frame);
        FrameResult result;
        result.totals = totals_of(outcome);
        result.full = full_render_of(outcome);
        result.errors.add(result.full, result.full.image);
        return result;
      },
      [&](std::uint64_t, FrameResult result) {
        add(sum, result.totals);
        row.errors.add(result.errors);
        full_.push_back(std::move(result.full));
        hooks_.progress();
      });
  fill_in(row, sum, plan_.full);
  full_rays_ = row.rays;
  simulator_.reset();
  present_ = nullptr;
  return row;
}

FrameResult Sweep::frame_of(const QualityPoint& point, const QualityRow& row, std::size_t frame) {
  const FrameOutcome outcome = simulate(row, point.unit, frame);
  FrameResult result;
  result.totals = totals_of(outcome);
  result.errors.add(full_[frame], frame_picture(outcome));
  result.attribution.emplace(plan_.worst, point.unit.selective.passes == hw::Passes::average);
  result.attribution->add(full_[frame], outcome);
  if (row.shown) result.part = hooks_.picture(row, outcome, full_[frame]);
  return result;
}

std::vector<QualityRow> Sweep::point_rows() {
  std::vector<QualityRow> rows;
  for (const QualityPoint& point : plan_.points) {
    QualityRow row;
    row.policy = point.policy;
    row.reference = point.reference;
    row.shown = point.shown;
    row.attribution.emplace(plan_.worst, point.unit.selective.passes == hw::Passes::average);
    rows.push_back(std::move(row));
    trees_.of(point.unit.accel);
  }
  const std::size_t frames = plan_.frames();
  Totals sum;
  in_order<FrameResult>(
      frames * rows.size(), plan_.jobs,
      [&](std::uint64_t task) { return frame_of(plan_.points[task / frames], rows[task / frames], task % frames); },
      [&](std::uint64_t task, const FrameResult& result) {
        QualityRow& row = rows[task / frames];
        add(sum, result.totals);
        row.errors.add(result.errors);
        row.attribution->add(*result.attribution);
        if (row.shown) hooks_.part(row, result.part);
        hooks_.progress();
        if (task % frames + 1 < frames) return;
        fill_in(row, sum, plan_.points[task / frames].unit);
        sum = {};
      });
  return rows;
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
  row.rays = static_cast<std::uint64_t>(std::llround(static_cast<double>(full_rays_) * row.traced_share()));
  return row;
}

}  // namespace

std::string QualityRow::name() const { return reference ? fmt::format("{}-{}", policy, *reference) : policy; }

std::vector<QualityRow> run_quality(const traces::Scene& scene, const QualityPlan& plan, const QualityHooks& hooks) {
  return Sweep(scene, plan, hooks).run();
}

}  // namespace artu::sim
