#include "sim/precision/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "ref/binary64.h"
#include "sim/driver/frame_simulator.h"
#include "sim/jobs/processes.h"
#include "sim/jobs/results.h"
#include "sim/report/names.h"
#include "sim/report/numbers.h"
#include "sim/report/pictures.h"

namespace artu::sim {
namespace {

bool same(const hw::PrecisionConfig& a, const hw::PrecisionConfig& b) {
  return a.box == b.box && a.triangle == b.triangle && a.shading == b.shading;
}

Image picture_of(const ref::Result& result) {
  Image image;
  image.width = result.width;
  image.height = result.height;
  image.rgb.reserve(result.pixels.size() * 3);
  for (const ref::Pixel& p : result.pixels) image.rgb.insert(image.rgb.end(), {p.r, p.g, p.b});
  return image;
}

using Pictures = std::vector<Image>;  // by frame

/// What is known of a format when its first tree is done.
struct FormatResult {
  std::vector<std::size_t> hashes;  // of its pictures: all of them would be too much memory
  ImageError from_binary32, from_binary64;
};

std::size_t hash_of(const Image& image) {
  return std::hash<std::string_view>()({reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size()});
}

/// What one frame of a row gives.
struct FrameResult {
  Totals totals;
  std::size_t hash = 0;
  ImageDifference from_binary32, from_binary64;  // with the first tree
  Image picture;                                 // of 23 bits with the first tree
};

template <class A>
void transfer(A& archive, FrameResult& r) {
  pass_all(archive, r.totals, r.hash, r.from_binary32, r.from_binary64, r.picture);
}

class Sweep {
 public:
  Sweep(const traces::Scene& scene, const SweepPlan& plan, const SweepHooks& hooks)
      : scene_(scene), plan_(plan), hooks_(hooks), trees_(scene) {}

  std::vector<SweepRow> run();

 private:
  void render_binary64();
  void simulate_binary32(SweepRow& row);
  void simulate_others(std::vector<SweepRow*> rows);

  hw::UnitConfig unit_of(const SweepRow& row) const;
  std::uint32_t index_of(std::size_t frame) const { return plan_.first_frame + static_cast<std::uint32_t>(frame); }
  std::size_t frames() const { return plan_.last_frame - plan_.first_frame; }
  FrameResult simulate(const SweepRow& row, std::size_t frame);
  /// Pictures of a format's first tree; those of the others must be equal.
  bool is_compared(const SweepRow& row) const { return row.tree == plan_.trees[0]; }
  void compare(const SweepRow& row, std::size_t frame, const Image& picture, FrameResult& result) const;
  /// In the order of the frames.
  void take(const SweepRow& row, std::size_t frame, const FrameResult& result, Totals& sum);
  /// When all frames were taken.
  void fill_in(SweepRow& row, const Totals& sum);

  const traces::Scene& scene_;
  const SweepPlan& plan_;
  const SweepHooks& hooks_;
  StaticTrees trees_;
  const SweepRow* present_ = nullptr;  // the simulator's; the frames of a row come one after the other
  std::unique_ptr<FrameSimulator> simulator_;
  Pictures binary64_, binary32_;
  double binary32_seconds_ = 0;
  std::map<std::string, FormatResult> known_;  // by the format's name
};

void Sweep::render_binary64() {
  const ref::Binary64 reference(scene_, plan_.unit.shading.max_depth, plan_.unit.shading.min_weight);
  in_order<Image>(
      frames(), plan_.jobs,
      [&](std::uint64_t frame) { return picture_of(reference.render(hooks_.frame(index_of(frame)))); },
      [&](std::uint64_t frame, Image picture) {
        binary64_.push_back(std::move(picture));
        hooks_.picture("binary64", index_of(frame), binary64_.back());
        hooks_.progress();
      });
}

hw::UnitConfig Sweep::unit_of(const SweepRow& row) const {
  hw::UnitConfig unit = plan_.unit;
  unit.accel.static_kind = unit.accel.dynamic_kind = row.tree;
  unit.precision = row.format;
  return unit;
}

FrameResult Sweep::simulate(const SweepRow& row, std::size_t frame) {
  if (present_ != &row) {
    SimulationOptions options;
    options.static_trees = &trees_;
    simulator_.reset();
    simulator_ = make_simulator(scene_, unit_of(row), options, hooks_.frame_from);
    present_ = &row;
  }
  const FrameOutcome outcome = simulator_->run(hooks_.frame(index_of(frame)));
  if (!outcome.violations.empty()) {
    throw std::logic_error(fmt::format("frame {}, {}, M {}: accounting law violated: {}", index_of(frame),
                                       tree_name(row.tree), format_name(row.format), outcome.violations[0]));
  }
  FrameResult result;
  result.totals = totals_of(outcome);
  result.picture = frame_picture(outcome);
  result.hash = hash_of(result.picture);
  return result;
}

void Sweep::compare(const SweepRow& row, std::size_t frame, const Image& picture, FrameResult& result) const {
  result.from_binary32 = compare_images(picture, binary32_[frame]);
  result.from_binary64 = compare_images(picture, binary64_[frame]);
  hooks_.picture("M" + format_name(row.format), index_of(frame), picture);
}

void Sweep::take(const SweepRow& row, std::size_t frame, const FrameResult& result, Totals& sum) {
  const std::string name = format_name(row.format);
  FormatResult& known = known_[name];
  if (is_compared(row)) {
    known.hashes.push_back(result.hash);
    known.from_binary32.add(result.from_binary32);
    known.from_binary64.add(result.from_binary64);
  } else if (known.hashes[frame] != result.hash) {
    throw std::logic_error(fmt::format("frame {}, M {}: {} shows another picture than {}", index_of(frame), name,
                                       tree_name(row.tree), tree_name(plan_.trees[0])));
  }
  add(sum, result.totals);
  hooks_.progress();
}

void Sweep::fill_in(SweepRow& row, const Totals& sum) {
  row.cycles = sum.cycles;
  row.rays = sum.rays();
  row.node_visits = sum.node_visits;
  row.triangle_tests = sum.triangle_tests;
  row.dram_bytes = sum.dram_read_bytes + sum.dram_write_bytes;
  row.traced_share = static_cast<double>(sum.sampled + sum.traced) / static_cast<double>(sum.pixels());
  for (const hw::Statistic& s : sum.statistics) {
    if (s.name == "box_tests") row.box_tests += s.value;
  }
  const FormatResult& known = known_[format_name(row.format)];
  row.from_binary32 = known.from_binary32;
  row.from_binary64 = known.from_binary64;
  row.run_time = sum.simulation_seconds / binary32_seconds_;
}

/// Its pictures and its time are what all others are compared with.
void Sweep::simulate_binary32(SweepRow& row) {
  Totals sum;
  in_order<FrameResult>(
      frames(), plan_.jobs, [&](std::uint64_t frame) { return simulate(row, frame); },
      [&](std::uint64_t frame, FrameResult result) {
        binary32_.push_back(std::move(result.picture));
        compare(row, frame, binary32_.back(), result);
        take(row, frame, result, sum);
      });
  binary32_seconds_ = sum.simulation_seconds;
  fill_in(row, sum);
  row.run_time = 1;
  simulator_.reset();
  present_ = nullptr;
}

void Sweep::simulate_others(std::vector<SweepRow*> rows) {
  Totals sum;
  in_order<FrameResult>(
      frames() * rows.size(), plan_.jobs,
      [&](std::uint64_t task) {
        const SweepRow& row = *rows[task / frames()];
        FrameResult result = simulate(row, task % frames());
        const Image picture = std::move(result.picture);
        if (is_compared(row)) compare(row, task % frames(), picture, result);
        result.picture = {};
        return result;
      },
      [&](std::uint64_t task, const FrameResult& result) {
        SweepRow& row = *rows[task / frames()];
        take(row, task % frames(), result, sum);
        if (task % frames() + 1 < frames()) return;
        fill_in(row, sum);
        sum = {};
      });
}

std::vector<SweepRow> Sweep::run() {
  render_binary64();
  std::vector<SweepRow> rows;
  for (const hw::TreeKind tree : plan_.trees) {
    for (const hw::PrecisionConfig& format : plan_.formats) {
      SweepRow row;
      row.tree = tree;
      row.format = format;
      rows.push_back(row);
      trees_.of(unit_of(row).accel);
    }
  }
  const auto reference =
      std::find_if(rows.begin(), rows.end(), [](const SweepRow& r) { return is_binary32(r.format); });
  simulate_binary32(*reference);
  std::vector<SweepRow*> others;
  for (SweepRow& row : rows) {
    if (&row != &*reference) others.push_back(&row);
  }
  simulate_others(others);
  return rows;
}

}  // namespace

SweepPlan completed(SweepPlan plan) {
  std::vector<hw::TreeKind> trees;
  for (const hw::TreeKind tree : plan.trees) {
    if (std::find(trees.begin(), trees.end(), tree) == trees.end()) trees.push_back(tree);
  }
  std::vector<hw::PrecisionConfig> formats;
  plan.formats.emplace_back();
  for (const hw::PrecisionConfig& format : plan.formats) {
    const auto is_it = [&](const hw::PrecisionConfig& f) { return same(f, format); };
    if (std::none_of(formats.begin(), formats.end(), is_it)) formats.push_back(format);
  }
  plan.trees = trees;
  plan.formats = formats;
  return plan;
}

std::string format_name(const hw::PrecisionConfig& f) {
  if (f.box == f.triangle && f.box == f.shading) return fmt::format("{}", f.box);
  return fmt::format("{}/{}/{}", f.box, f.triangle, f.shading);
}

std::uint64_t sweep_steps(const SweepPlan& plan) {
  return std::uint64_t{plan.last_frame - plan.first_frame} * (1 + plan.trees.size() * plan.formats.size());
}

std::vector<SweepRow> run_sweep(const traces::Scene& scene, const SweepPlan& plan, const SweepHooks& hooks) {
  return Sweep(scene, plan, hooks).run();
}

}  // namespace artu::sim
