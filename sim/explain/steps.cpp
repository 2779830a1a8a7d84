#include "sim/explain/steps.h"

#include <algorithm>
#include <cmath>

#include "sim/explain/advice.h"

namespace artu::sim {
namespace {

/// What goes with misses of an L1 that do not happen any more, and with those of the L2.
const std::set<Resource> below_l1{Resource::node_caches, Resource::triangle_caches, Resource::texture_caches,
                                  Resource::l2_banks,    Resource::dram_buses,      Resource::dram_rows};
const std::set<Resource> below_l2{Resource::l2_banks, Resource::dram_buses, Resource::dram_rows};

class Steps {
 public:
  Steps(const Accounting& account, const Totals& totals, const hw::UnitConfig& unit)
      : a_(account), totals_(totals), unit_(unit) {}

  std::vector<Step> take() { return std::move(steps_); }

  /// A parameter of which more, or with `factor` 0.5 less, is better.
  Step& turn(const std::string& parameter, double factor = 2) {
    const double value = std::stod(value_of(unit_, parameter));
    const double to = factor > 1 ? value * factor : std::max(value * factor, std::min(value, 1.0));
    Step step;
    step.parameter = parameter;
    step.to = std::to_string(static_cast<std::uint64_t>(to));
    step.at_most = value == 0   ? 0
                   : factor > 1 ? factor
                                : value / std::max(1.0, static_cast<double>(static_cast<std::uint64_t>(to)));
    steps_.push_back(step);
    return steps_.back();
  }
  Step& choose(const std::string& parameter, const std::string& value) {
    Step step;
    step.parameter = parameter;
    step.to = value;
    step.at_most = 0;
    steps_.push_back(step);
    return steps_.back();
  }

  void more_cores() { turn("core.count"); }
  /// Fewer misses: no limit but what is asked for without them.
  void larger(const std::string& cache, const std::set<Resource>& relieves) {
    Step& step = turn(cache + ".size");
    step.relieves = relieves;
    step.at_most = 0;
    memory(step);
  }
  /// Memory that answers sooner shortens what the tree builder waits for it.
  void memory(Step& step) const { step.build_saved = step.build_saved_far = a_.builder - a_.builder_computes; }
  void more_channels() {
    Step& step = turn("memory.dram.channels");
    step.flush_left = 0.5;
    memory(step);
  }

  void box_testers();
  void l1(const Finding& finding);
  void l2(const Finding& finding);
  void dram_latency();
  void l2_latency();
  void candidates(const Finding& finding);
  void build();

 private:
  /// The least that the same triangles take by Morton codes (hw/memory/build_plan.h).
  double morton_computes() const;
  /// The L1 whose misses are the most.
  std::string most_missed() const;

  const Accounting& a_;
  const Totals& totals_;
  const hw::UnitConfig& unit_;
  std::vector<Step> steps_;
};

void Steps::box_testers() {
  // The testers are given a node no more often than once in node_interval, whatever their number.
  hw::UnitConfig more = unit_;
  more.core.box_testers = 8;
  const bool interval = account(totals_, more).need(Resource::box_testers) > 0.99 * a_.need(Resource::box_testers);
  if (interval) turn("core.node_interval", 0.5);
  if (!interval) turn("core.box_testers");
}

std::string Steps::most_missed() const {
  const std::pair<Place, const char*> caches[] = {{Place::node_misses, "core.node_cache"},
                                                  {Place::triangle_misses, "core.triangle_cache"},
                                                  {Place::texture_misses, "core.texture_cache"}};
  const char* name = "";
  double most = -1;
  for (const auto& [place, cache] : caches) {
    if (a_.taken_of(place) > most) name = cache;
    most = std::max(most, a_.taken_of(place));
  }
  return name;
}

void Steps::l1(const Finding& finding) {
  if (finding.throughput) {
    if (finding.resource == Resource::texture_caches && !unit_.skip.texture) {
      choose("skip.texture", "true").relieves = below_l1;
    }
    return more_cores();
  }
  const std::string cache = most_missed();
  turn(cache + ".mshrs");
  larger(cache, below_l1);
}

void Steps::l2(const Finding& finding) {
  if (finding.throughput) {
    memory(turn("memory.l2_banks"));
  } else {
    memory(turn("memory.l2.mshrs"));
    larger("memory.l2", below_l2);
  }
  larger(most_missed(), below_l1);
}

void Steps::dram_latency() {
  memory(turn("core.contexts"));
  steps_.back().build_saved = steps_.back().build_saved_far = 0;
  larger("memory.l2", below_l2);
  const hw::DramConfig& dram = unit_.memory.dram;
  if (dram.t_cl >= dram.t_rcd + dram.t_rp) {
    memory(turn("memory.dram.t_cl", 0.5));
  } else {
    memory(turn("memory.dram.t_rcd", 0.5));
  }
}

void Steps::l2_latency() {
  turn("core.contexts");
  larger(most_missed(), below_l1);
  const bool way = 2 * unit_.memory.interconnect_latency >= unit_.memory.l2.hit_latency;
  memory(turn(way ? "memory.interconnect_latency" : "memory.l2.hit_latency", 0.5));
}

void Steps::candidates(const Finding& finding) {
  // Wider tiles: fewer lines are asked for more than once.
  const std::set<Resource> extractor{Resource::extractor, Resource::l2_banks, Resource::dram_buses,
                                     Resource::dram_rows};
  if (!finding.throughput) {
    turn("selective.pixel_cache.mshrs");
    larger("selective.pixel_cache", extractor);
  } else {
    hw::UnitConfig sooner = unit_;
    sooner.selective.pixel_cache.hit_latency = 1;
    const bool waits = account(totals_, sooner).need(Resource::extractor) < 0.99 * a_.need(Resource::extractor);
    if (waits) turn("selective.pixel_cache.hit_latency", 0.5);
  }
  Step& tile = turn("selective.tile");
  tile.relieves = extractor;
  tile.at_most = 0;
}

double Steps::morton_computes() const {
  const hw::TreeBuilderConfig& builder = unit_.tree_builder;
  const double n = a_.builder_triangles, sorts = std::ceil(3.0 * builder.code_bits / builder.digit_bits);
  const double records = n * (sorts + 2 + (builder.known_box ? 0 : 1));
  return records * builder.cycles_per_record + (n - 1) * (builder.cycles_per_node + 2.0 * builder.cycles_per_box);
}

void Steps::build() {
  const double traffic = a_.builder - a_.builder_computes;
  const hw::TreeBuilderConfig& builder = unit_.tree_builder;
  const auto saves = [&builder](Step& step, double cycles, double step_share) {
    // With overlap the passes' cycles hold the wait for the tree, so that only what is asked of them bounds them.
    step.at_most = builder.overlap ? 0 : 1;
    step.build_saved = cycles * step_share;
    step.build_saved_far = cycles;
  };
  if (traffic > a_.builder_computes) {
    saves(turn("tree_builder.outstanding"), traffic, 0.5);
    more_channels();
    saves(steps_.back(), traffic, 0.5);
    return;
  }
  if (builder.algorithm == hw::BuildAlgorithm::sah) {
    if (a_.builder_sweeps > 0.5 * a_.builder_computes) {
      saves(turn("tree_builder.cycles_per_bin", 0.5), a_.builder_sweeps, 0.5);
      saves(turn("tree_builder.bins", 0.5), a_.builder_sweeps, 0.5);
    } else {
      saves(turn("tree_builder.binning_units"), a_.builder_computes - a_.builder_sweeps, 0.5);
    }
    saves(choose("tree_builder.algorithm", "morton"), std::max(a_.builder - morton_computes(), 0.0), 1);
  } else {
    saves(turn("tree_builder.cycles_per_record", 0.5), a_.builder_computes, 0.5);
  }
  if (!builder.overlap) {
    // What goes on beside the passes costs nothing, at most; but they do not end before it does.
    saves(choose("tree_builder.overlap", "true"), std::min(a_.build, a_.passes()), 1);
  }
}

}  // namespace

std::vector<Step> steps_for(const Finding& finding, const Accounting& account, const Totals& totals,
                            const hw::UnitConfig& unit) {
  Steps steps(account, totals, unit);
  switch (finding.bound) {
    case Bound::traversal:
      if (finding.resource == Resource::box_testers) steps.box_testers();
      steps.more_cores();
      break;
    case Bound::intersection:
      steps.turn("core.triangle_interval", 0.5);
      steps.more_cores();
      break;
    case Bound::hit_points:
    case Bound::shading:
      steps.more_cores();
      break;
    case Bound::l1:
      steps.l1(finding);
      break;
    case Bound::l2:
      steps.l2(finding);
      break;
    case Bound::dram_bandwidth:
      steps.more_channels();
      steps.larger("memory.l2", below_l2);
      if (finding.resource == Resource::dram_rows) steps.memory(steps.turn("memory.dram.banks"));
      break;
    case Bound::dram_latency:
      steps.dram_latency();
      break;
    case Bound::l2_latency:
      steps.l2_latency();
      break;
    case Bound::pipeline_latency:
      steps.turn("core.contexts");
      steps.more_cores();
      break;
    case Bound::queue_depth:
      steps.memory(steps.turn("memory.dram.queue_depth"));
      steps.more_channels();
      steps.larger("memory.l2", below_l2);
      break;
    case Bound::candidate_extraction:
      steps.candidates(finding);
      break;
    case Bound::uneven_cores:
      if (unit.core.dispatch == hw::Dispatch::tiles) steps.choose("core.dispatch", "first-come");
      break;
    case Bound::too_few_pixels:
      if (unit.selective.enabled && !unit.selective.overlap) steps.choose("selective.overlap", "true");
      steps.turn("core.queue_depth");
      steps.turn("selective.tile", 0.5);
      break;
    case Bound::tree_build:
      steps.build();
      break;
    case Bound::start:
      steps.turn("memory.interconnect_latency", 0.5).shortens_start = true;
      break;
    case Bound::write_back:
      steps.more_channels();
      break;
    case Bound::frame_writer:
    case Bound::dispatcher:
      break;  // a pixel a cycle is fixed
  }
  return steps.take();
}

}  // namespace artu::sim
