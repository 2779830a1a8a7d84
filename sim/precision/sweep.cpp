#include "sim/precision/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>
#include <string_view>

#include "ref/binary64.h"
#include "sim/driver/frame_simulator.h"
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

class Sweep {
 public:
  Sweep(const traces::Scene& scene, const SweepPlan& plan, const SweepHooks& hooks)
      : scene_(scene), plan_(plan), hooks_(hooks) {}

  std::vector<SweepRow> run();

 private:
  void render_binary64();
  /// Simulates all frames; returns their pictures.
  Pictures simulate(SweepRow& row, double& seconds);
  /// Fills in the errors.  Of a later tree they are those of the first, since its pictures must be equal.
  void compare(SweepRow& row, const Pictures& pictures);
  FormatResult first_compared(const SweepRow& row, const Pictures& pictures);

  const traces::Scene& scene_;
  const SweepPlan& plan_;
  const SweepHooks& hooks_;
  Pictures binary64_, binary32_;
  std::map<std::string, FormatResult> known_;  // by the format's name
};

void Sweep::render_binary64() {
  const ref::Binary64 reference(scene_, plan_.unit.shading.max_depth, plan_.unit.shading.min_weight);
  for (std::uint32_t index = plan_.first_frame; index < plan_.last_frame; ++index) {
    binary64_.push_back(picture_of(reference.render(hooks_.frame(index))));
    hooks_.picture("binary64", index, binary64_.back());
    hooks_.progress();
  }
}

Pictures Sweep::simulate(SweepRow& row, double& seconds) {
  hw::UnitConfig unit = plan_.unit;
  unit.accel.static_kind = unit.accel.dynamic_kind = row.tree;
  unit.precision = row.format;
  const auto simulator = make_simulator(scene_, unit, {}, hooks_.frame_from);
  Pictures pictures;
  Totals sum;
  for (std::uint32_t index = plan_.first_frame; index < plan_.last_frame; ++index) {
    const FrameOutcome outcome = simulator->run(hooks_.frame(index));
    if (!outcome.violations.empty()) {
      throw std::logic_error(fmt::format("frame {}, {}, M {}: accounting law violated: {}", index, tree_name(row.tree),
                                         format_name(row.format), outcome.violations[0]));
    }
    add(sum, totals_of(outcome));
    pictures.push_back(frame_picture(outcome));
    hooks_.progress();
  }
  row.cycles = sum.cycles;
  row.rays = sum.rays();
  row.node_visits = sum.node_visits;
  row.triangle_tests = sum.triangle_tests;
  row.dram_bytes = sum.dram_read_bytes + sum.dram_write_bytes;
  row.traced_share = static_cast<double>(sum.sampled + sum.traced) / static_cast<double>(sum.pixels());
  for (const hw::Statistic& s : sum.statistics) {
    if (s.name == "box_tests") row.box_tests += s.value;
  }
  seconds = sum.simulation_seconds;
  return pictures;
}

FormatResult Sweep::first_compared(const SweepRow& row, const Pictures& pictures) {
  FormatResult result;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    result.hashes.push_back(hash_of(pictures[i]));
    result.from_binary32.add(compare_images(pictures[i], binary32_[i]));
    result.from_binary64.add(compare_images(pictures[i], binary64_[i]));
    hooks_.picture("M" + format_name(row.format), plan_.first_frame + static_cast<std::uint32_t>(i), pictures[i]);
  }
  return result;
}

void Sweep::compare(SweepRow& row, const Pictures& pictures) {
  const std::string name = format_name(row.format);
  auto known = known_.find(name);
  if (known == known_.end()) known = known_.emplace(name, first_compared(row, pictures)).first;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (known->second.hashes[i] == hash_of(pictures[i])) continue;
    throw std::logic_error(fmt::format("frame {}, M {}: {} shows another picture than {}", plan_.first_frame + i, name,
                                       tree_name(row.tree), tree_name(plan_.trees[0])));
  }
  row.from_binary32 = known->second.from_binary32;
  row.from_binary64 = known->second.from_binary64;
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
    }
  }
  // Its pictures and its time are what all others are compared with.
  const auto reference =
      std::find_if(rows.begin(), rows.end(), [](const SweepRow& r) { return is_binary32(r.format); });
  double reference_seconds = 0;
  binary32_ = simulate(*reference, reference_seconds);
  reference->run_time = 1;
  compare(*reference, binary32_);
  for (SweepRow& row : rows) {
    if (&row == &*reference) continue;
    double seconds = 0;
    compare(row, simulate(row, seconds));
    row.run_time = seconds / reference_seconds;
  }
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
