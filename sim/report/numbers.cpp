#include "sim/report/numbers.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/report/cycle_table.h"

namespace artu::sim {
namespace {

/// 0 / 0 is 0 in a report: a frame without rays has no rays per second.
double ratio(double a, double b) { return b == 0 ? 0 : a / b; }

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void add(hw::Statistics& sum, const hw::Statistics& frame) {
  for (std::size_t i = 0; i < frame.size(); ++i) {
    // The order is fixed, so the counter is nearly always at the same place.
    const hw::Statistic& counter = frame[i];
    const auto same = [&](const hw::Statistic& s) { return s.block == counter.block && s.name == counter.name; };
    auto found = i < sum.size() && same(sum[i]) ? sum.begin() + i : std::find_if(sum.begin(), sum.end(), same);
    if (found == sum.end()) {
      sum.push_back(counter);
    } else {
      found->value = is_peak(counter.name) ? std::max(found->value, counter.value) : found->value + counter.value;
    }
  }
}

void add(std::vector<Estimate>& sum, const std::vector<Estimate>& frame) {
  for (const Estimate& e : frame) {
    const auto same = [&e](const Estimate& s) { return s.block == e.block && s.name == e.name; };
    const auto found = std::find_if(sum.begin(), sum.end(), same);
    if (found == sum.end()) {
      sum.push_back(e);
    } else if (is_peak(e.name)) {
      found->value = std::max(found->value, e.value);
      found->low = std::max(found->low, e.low);
      found->high = std::max(found->high, e.high);
    } else {
      found->value += e.value;
      found->low += e.low;
      found->high += e.high;
    }
  }
}

/// A number that needs the cycles or the memory's traffic is left out where there are none.
void leave_out_time(std::vector<Number>& numbers) {
  const auto timed = [](const Number& n) {
    for (const char* name : {"cycles", "fps", "mrays_per_second", "cycles_per_frame", "cycles_per_second"}) {
      if (n.name == name) return true;
    }
    return starts_with(n.name, "dram");
  };
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), timed), numbers.end());
}

void keep_largest(TreeQuality& sum, const TreeQuality& frame) {
  sum.nodes = std::max(sum.nodes, frame.nodes);
  sum.leaves = std::max(sum.leaves, frame.leaves);
  sum.references = std::max(sum.references, frame.references);
  sum.depth = std::max(sum.depth, frame.depth);
  if (frame.sah_cost() <= sum.sah_cost()) return;
  sum.box_tests = frame.box_tests;
  sum.triangle_tests = frame.triangle_tests;
}

void count_pixels(const hw::PixelRecords& pixels, Totals& totals) {
  for (const hw::PixelRecord& pixel : pixels) {
    totals.sampled += pixel.decision == hw::Decision::sampled;
    totals.interpolated += pixel.decision == hw::Decision::interpolated;
    totals.traced += pixel.decision == hw::Decision::traced;
    totals.miss += pixel.hit_class == hw::HitClass::miss;
    totals.static_hits += pixel.hit_class == hw::HitClass::static_geometry;
    totals.dynamic_hits += pixel.hit_class == hw::HitClass::dynamic_geometry;
  }
}

std::string tree_cost_text() {
  return fmt::format("of such a ray: a box test counts {}, a triangle test {}", box_test_cost, triangle_test_cost);
}

/// Hits and misses of all caches of a kind: "core0.node_cache" and "core1.node_cache" are one kind.
struct HitRate {
  std::string kind;
  std::uint64_t hits = 0, misses = 0;
};

std::string kind_of(const std::string& block) {
  const std::string name = without_number(block);
  return name.substr(name.rfind('.') + 1);
}

std::vector<HitRate> hit_rates(const hw::Statistics& statistics) {
  std::vector<HitRate> rates;
  for (const hw::Statistic& s : statistics) {
    if (s.name != "hits" && s.name != "misses") continue;
    const std::string kind = kind_of(s.block);
    auto rate = std::find_if(rates.begin(), rates.end(), [&](const HitRate& r) { return r.kind == kind; });
    if (rate == rates.end()) rate = rates.insert(rates.end(), {kind});
    (s.name == "hits" ? rate->hits : rate->misses) += s.value;
  }
  // A block that only counts hits is no cache.
  const auto no_cache = [&](const HitRate& rate) {
    return std::none_of(statistics.begin(), statistics.end(),
                        [&](const hw::Statistic& s) { return s.name == "misses" && kind_of(s.block) == rate.kind; });
  };
  rates.erase(std::remove_if(rates.begin(), rates.end(), no_cache), rates.end());
  return rates;
}

}  // namespace

bool is_peak(const std::string& name) {
  return starts_with(name, "peak_") || starts_with(name, "max_") || ends_with(name, "_peak") || ends_with(name, "_max");
}

Totals totals_of(const FrameOutcome& o) {
  Totals t;
  t.fidelity = o.fidelity;
  t.frames = 1;
  t.cycles = o.cycles;
  t.static_triangles = o.static_triangles;
  t.dynamic_triangles = o.dynamic_triangles;
  t.dynamic_tree = o.dynamic_tree;
  count_pixels(o.pixels, t);
  t.rays_primary = o.rays_primary;
  t.rays_shadow = o.rays_shadow;
  t.rays_reflection = o.rays_reflection;
  t.rays_refraction = o.rays_refraction;
  t.node_visits = o.node_visits;
  t.triangle_tests = o.triangle_tests;
  t.dram_read_bytes = o.dram_read_bytes;
  t.dram_write_bytes = o.dram_write_bytes;
  t.simulation_seconds = o.simulation_seconds;
  t.statistics = o.statistics;
  t.estimates = o.estimates;
  return t;
}

void add(Totals& sum, const Totals& frame) {
  static constexpr std::uint64_t Totals::*counts[] = {
      &Totals::frames,       &Totals::cycles,         &Totals::sampled,         &Totals::interpolated,
      &Totals::traced,       &Totals::miss,           &Totals::static_hits,     &Totals::dynamic_hits,
      &Totals::rays_primary, &Totals::rays_shadow,    &Totals::rays_reflection, &Totals::rays_refraction,
      &Totals::node_visits,  &Totals::triangle_tests, &Totals::dram_read_bytes, &Totals::dram_write_bytes};
  sum.fidelity = frame.fidelity;
  for (const auto count : counts) sum.*count += frame.*count;
  sum.static_triangles = std::max(sum.static_triangles, frame.static_triangles);
  sum.dynamic_triangles = std::max(sum.dynamic_triangles, frame.dynamic_triangles);
  keep_largest(sum.dynamic_tree, frame.dynamic_tree);
  sum.simulation_seconds += frame.simulation_seconds;
  add(sum.statistics, frame.statistics);
  add(sum.estimates, frame.estimates);
  sum.memory.keep_larger(frame.memory);
}

std::vector<Number> frame_numbers(const Totals& t) {
  const double traced_share = ratio(static_cast<double>(t.sampled + t.traced), static_cast<double>(t.pixels()));
  std::vector<Number> numbers = {
      {"cycles", t.cycles, "cycles", "of the unit's clock, from start to the last write-back"},
      {"triangles.static", t.static_triangles, "triangles", "static geometry"},
      {"triangles.dynamic", t.dynamic_triangles, "triangles", "dynamic geometry (of several frames: the most)"},
      {"tree.nodes", t.dynamic_tree.nodes, "nodes", "of the dynamic geometry's tree (of several frames: the most)"},
      {"tree.leaves", t.dynamic_tree.leaves, "leaves", "the same"},
      {"tree.references", t.dynamic_tree.references, "triangles", "in all leaves; the same"},
      {"tree.depth", t.dynamic_tree.depth, "nodes", "on the longest path down; the same"},
      {"tree.box_tests", t.dynamic_tree.box_tests, "boxes",
       "expected for a ray that meets the root box, by surface area; of a kd-tree planes (of several frames: the "
       "costliest's)"},
      {"tree.triangle_tests", t.dynamic_tree.triangle_tests, "triangles", "expected for such a ray; the same"},
      {"tree.sah_cost", t.dynamic_tree.sah_cost(), "boxes", tree_cost_text()},
      {"rays.primary", t.rays_primary, "rays", "traced from the camera"},
      {"rays.shadow", t.rays_shadow, "rays", "traced towards lights"},
      {"rays.reflection", t.rays_reflection, "rays", "traced after a mirror"},
      {"rays.refraction", t.rays_refraction, "rays", "traced through a surface"},
      {"candidates.interpolated", t.interpolated, "pixels", "candidates whose colour was interpolated"},
      {"candidates.traced", t.traced, "pixels", "candidates that were ray traced"},
      {"pixels.total", t.pixels(), "pixels", "of the picture"},
      {"pixels.sampled", t.sampled, "pixels", "sampling pixels, always ray traced"},
      {"pixels.miss", t.miss, "pixels", "ray-traced pixels whose primary ray hit nothing"},
      {"pixels.static", t.static_hits, "pixels", "ray-traced pixels whose primary ray hit static geometry"},
      {"pixels.dynamic", t.dynamic_hits, "pixels", "ray-traced pixels whose primary ray hit dynamic geometry"},
      {"traced_share", traced_share, "", "ray-traced pixels, sampled ones included, of all pixels"},
      {"node_visits", t.node_visits, "nodes", "tree nodes visited by all rays"},
      {"triangle_tests", t.triangle_tests, "triangles", "triangles tested by all rays"},
      {"dram.read_bytes", t.dram_read_bytes, "bytes", "read from DRAM"},
      {"dram.write_bytes", t.dram_write_bytes, "bytes", "written to DRAM"},
  };
  if (!has_cycles(t.fidelity)) leave_out_time(numbers);
  return numbers;
}

std::vector<Number> derived_numbers(const Totals& t, std::uint32_t clock_mhz) {
  const auto frames = static_cast<double>(t.frames), cycles = static_cast<double>(t.cycles);
  const auto rays = static_cast<double>(t.rays());
  const auto bytes = static_cast<double>(t.dram_read_bytes + t.dram_write_bytes);
  const double seconds = cycles / (clock_mhz * 1e6);
  std::vector<Number> numbers = {
      {"cycles_per_frame", ratio(cycles, frames), "cycles", "mean"},
      {"fps", ratio(frames, seconds), "frames/s", "simulated frames per second at the configured clock"},
      {"mrays_per_second", ratio(rays, seconds) / 1e6, "Mrays/s", "simulated, rays of all kinds"},
      {"rays_per_pixel", ratio(rays, static_cast<double>(t.pixels())), "rays", "of all kinds, mean"},
      {"node_visits_per_ray", ratio(static_cast<double>(t.node_visits), rays), "nodes", "mean"},
      {"triangle_tests_per_ray", ratio(static_cast<double>(t.triangle_tests), rays), "triangles", "mean"},
      {"dram_gb_per_second", ratio(bytes, seconds) / 1e9, "GB/s", "simulated DRAM traffic, both ways"},
      {"dram_bytes_per_ray", ratio(bytes, rays), "bytes", "DRAM traffic, both ways"},
  };
  if (!has_cycles(t.fidelity)) leave_out_time(numbers);
  for (const HitRate& rate : hit_rates(t.statistics)) {
    numbers.push_back({"hit_rate." + rate.kind,
                       ratio(static_cast<double>(rate.hits), static_cast<double>(rate.hits + rate.misses)), "",
                       "share of hits, all caches of the kind together"});
  }
  return numbers;
}

std::vector<Number> simulation_numbers(const Totals& t, double golden_seconds) {
  const double seconds = t.simulation_seconds;
  std::vector<Number> numbers = {
      {"wall_seconds", seconds, "s", "wall time of the simulation, without loading and tree builds"},
      {"rays_per_second", ratio(static_cast<double>(t.rays()), seconds), "rays/s", "simulation speed"},
      {"node_visits_per_second", ratio(static_cast<double>(t.node_visits), seconds), "nodes/s", "simulation speed"},
      {"cycles_per_second", ratio(static_cast<double>(t.cycles), seconds), "cycles/s", "simulation speed"},
  };
  if (!has_cycles(t.fidelity)) leave_out_time(numbers);
  const auto triangles = static_cast<double>(t.static_triangles + t.dynamic_triangles);
  const double pixels = ratio(static_cast<double>(t.pixels()), static_cast<double>(t.frames));
  numbers.insert(numbers.end(),
                 {{"peak_bytes", t.memory.peak, "bytes", "most memory of the host at any time (of a process)"},
                  {"bytes_per_triangle", ratio(static_cast<double>(t.memory.loading), triangles), "bytes",
                   "memory that loading the scene and building trees took at most, a triangle"},
                  {"bytes_per_pixel", ratio(static_cast<double>(t.memory.frames), pixels), "bytes",
                   "memory that the frames took at most on top, a pixel of one frame"}});
  if (golden_seconds >= 0) {
    numbers.push_back({"golden_seconds", golden_seconds, "s", "wall time of the golden model, without tree builds"});
  }
  return numbers;
}

std::string value_text(const Number& number) {
  if (const auto* count = std::get_if<std::uint64_t>(&number.value)) return fmt::format("{}", *count);
  return fmt::format("{:.6g}", std::get<double>(number.value));
}

}  // namespace artu::sim
