// Events from counters: which block does what how often.
#include <algorithm>

#include "hw/datapath/node_visit.h"
#include "hw/datapath/operations.h"
#include "hw/datapath/shading.h"
#include "hw/datapath/triangle.h"
#include "hw/fabric/memory_port.h"
#include "hw/memory/dram_channel.h"
#include "hw/selective/policy.h"
#include "sim/energy/energy.h"
#include "sim/energy/prices.h"
#include "sim/report/counters.h"

namespace artu::sim {
namespace {

namespace op = hw::operations;
namespace integer_op = hw::integer_operations;

constexpr std::uint64_t line = hw::line_bytes;
constexpr std::uint64_t request_bytes = 8;  // address, tag and mask of a request

/// Of two trees of different kinds, whose tests are counted together: the dearer test.
hw::Operations larger(hw::Operations a, hw::Operations b) {
  return {std::max(a.add, b.add), std::max(a.multiply, b.multiply), std::max(a.divide, b.divide),
          std::max(a.square_root, b.square_root), std::max(a.compare, b.compare)};
}

class Model {
 public:
  Model(const Totals& totals, const hw::UnitConfig& unit)
      : counters_(totals.statistics), cycles_(totals.cycles), unit_(unit), energy_(unit.energy) {}

  std::vector<EnergyItem> items() {
    core();
    caches();
    memory();
    selective();
    leakage();
    return std::move(items_);
  }

 private:
  std::uint64_t count(const char* block, const char* name) const { return counters_.of(block, name); }

  void add(const char* block, const char* event, std::uint64_t count, double price) {
    items_.push_back({block, event, count, price});
  }

  /// `tests` times these operators, of this width.
  void operate(const char* block, std::uint64_t tests, const hw::Operations& o, std::uint32_t bits) {
    const OperatorPrices p = operator_prices(energy_, bits);
    add(block, "operators.add", tests * o.add, p.add);
    add(block, "operators.multiply", tests * o.multiply, p.multiply);
    add(block, "operators.divide", tests * o.divide, p.divide);
    add(block, "operators.square_root", tests * o.square_root, p.square_root);
    add(block, "operators.compare", tests * o.compare, p.compare);
  }
  void operate(const char* block, std::uint64_t tests, const hw::DatapathOperations& o, std::uint32_t bits) {
    operate(block, tests, o.narrow, bits);
    operate(block, tests, o.binary32, hw::most_fraction_bits);
  }
  void integers(const char* block, std::uint64_t operations) {
    add(block, "operators.integer", operations, double{energy_.operators.integer} * energy_.scale);
  }
  void registers(const char* block, std::uint64_t bytes) {
    add(block, "wires.registers", bytes, energy_.wires.registers);
  }
  void wires(const char* block, std::uint64_t bytes, double length) {
    add(block, "wires.wire", bytes, energy_.wires.wire * length);
  }

  void core() {
    const std::uint64_t shadow_rays = count("core.ray_generator", "shadow_rays");
    const std::uint64_t primary_rays = count("core.ray_generator", "primary_rays");
    const std::uint64_t rays = primary_rays + shadow_rays + count("core.ray_generator", "reflection_rays") +
                               count("core.ray_generator", "refraction_rays");
    operate("core.ray_generator", primary_rays, op::primary_ray, hw::most_fraction_bits);
    operate("core.ray_generator", rays, op::ray_set_up, hw::most_fraction_bits);
    registers("core.ray_generator", rays * sizeof(hw::Ray));
    traversal(rays);
    intersection();
    shading(shadow_rays);
  }

  void traversal(std::uint64_t rays) {
    const hw::DatapathOperations a = op::box_test(unit_.accel.static_kind), b = op::box_test(unit_.accel.dynamic_kind);
    const hw::DatapathOperations box{larger(a.narrow, b.narrow), larger(a.binary32, b.binary32)};
    operate("core.traversal", count("core.traversal", "box_tests"), box, unit_.precision.box);
    // A step reads the ray and its limit and writes what is next; a stack entry is written and read once.
    const std::uint64_t visits = count("core.traversal", "node_visits");
    const std::uint64_t pushes = count("core.traversal", "stack_pushes");
    const std::uint64_t ray_bytes = 3 * sizeof(hw::Vector) + sizeof(float);
    registers("core.traversal", (visits + rays) * (ray_bytes + sizeof(hw::Step)) + pushes * 2 * sizeof(hw::Step));
  }

  void intersection() {
    const std::uint64_t tests = count("core.intersection", "triangle_tests");
    operate("core.intersection", tests, op::triangle_test, unit_.precision.triangle);
    operate("core.intersection", tests, op::box_interval, unit_.precision.box);
    registers("core.intersection",
              tests * sizeof(hw::Ray) + count("core.intersection", "hits") * sizeof(hw::TriangleHit));
    const std::uint64_t points = count("core.hit_point", "hit_points");
    operate("core.hit_point", points, op::hit_point, hw::most_fraction_bits);
    registers("core.hit_point", points * (sizeof(hw::Ray) + sizeof(hw::TriangleHit) + sizeof(hw::Surface)));
  }

  void shading(std::uint64_t shadow_rays) {
    const std::uint32_t bits = unit_.precision.shading;
    const std::uint64_t hits = count("core.shading", "hits_shaded"), lights = count("core.shading", "lights");
    const std::uint64_t sky = count("core.shading", "sky");
    operate("core.shading", hits, op::begin_shading + op::add_weighted, bits);
    if (unit_.shading.max_depth != 0) operate("core.shading", hits, op::next_rays, bits);
    operate("core.shading", count("core.shading", "textured"), op::texture_address + op::texture_filter, bits);
    operate("core.shading", lights, op::light, bits);
    operate("core.shading", shadow_rays, op::add, bits);
    operate("core.shading", sky, op::sky + op::add_weighted, bits);
    const std::uint64_t sum_bytes = 2 * sizeof(hw::Vector);  // the pixel's sum, read and written
    registers("core.shading", hits * (sizeof(hw::Surface) + sizeof(hw::ShadedPoint) + sum_bytes) +
                                  lights * sizeof(hw::ShadedPoint) + (sky + shadow_rays) * sum_bytes);
  }

  /// Every access moves a whole line: requests of above, fills, and lines that are written back.
  void cache(const char* block, const hw::CacheConfig& config) {
    const std::uint64_t requests = count(block, "reads") + count(block, "writes");
    add(block, "sram.access", requests + count(block, "fills") + count(block, "write_backs"),
        line_price(energy_, config.size));
  }

  void caches() {
    const auto first_level = [this](const char* block, const hw::CacheConfig& config) {
      cache(block, config);
      wires(block, (count(block, "reads") + count(block, "writes")) * line, energy_.wires.core_length);
    };
    first_level("core.node_cache", unit_.core.node_cache);
    first_level("core.triangle_cache", unit_.core.triangle_cache);
    first_level("core.texture_cache", unit_.core.texture_cache);
    first_level("pixel_cache", unit_.selective.pixel_cache);
    hw::CacheConfig bank = unit_.memory.l2;
    bank.size /= unit_.memory.l2_banks;
    cache("l2", bank);
  }

  void memory() {
    // A read comes back with a line, a write brings one; lines between the L2 and the DRAM's pins go the same way.
    const std::uint64_t moved = count("l2", "reads") + count("l2", "writes");
    wires("interconnect", count("interconnect", "requests") * request_bytes + moved * line, energy_.wires.chip_length);
    const std::uint64_t read = count("dram", "read_bytes"), written = count("dram", "write_bytes");
    wires("interconnect", read + written, energy_.wires.chip_length);

    const hw::DramConfig& part = unit_.memory.dram;
    const std::uint64_t bursts = hw::bus_bytes_of_line(part);
    const bool by_bank = part.refresh == hw::RefreshPolicy::per_bank;
    add("dram", "dram.activate", count("dram", "activates"), energy_.dram.activate);
    add("dram", "dram.read", count("dram", "reads") * bursts, energy_.dram.read);
    add("dram", "dram.write", count("dram", "writes") * bursts, energy_.dram.write);
    add("dram", "dram.refresh", count("dram", "refreshes"), energy_.dram.refresh / (by_bank ? part.banks : 1.0));
    add("dram", "dram.background", cycles_ * part.channels, cycle_price(energy_.dram.background, unit_.clock_mhz));

    add("tree_builder", "build", count("tree_builder", "triangles"), double{energy_.build} * energy_.scale);
  }

  void selective() {
    const std::uint64_t candidates = count("candidate_pixel_extractor", "candidates");
    integers("collision_counter", candidates * integer_op::count_hits);
    integers("threshold_adjuster", candidates * hw::policy(unit_.selective.policy).operations);
    integers("render_executor",
             count("render_executor", "differences") * integer_op::color_difference(unit_.selective.metric) +
                 count("render_executor", "interpolated") * integer_op::interpolate);
    const std::uint64_t pixel_bytes = 5;  // colour and class, written and read again
    registers("frame_writer", count("frame_writer", "pixels") * 2 * pixel_bytes);
  }

  void leakage() {
    add("static", "leakage.core", cycles_ * unit_.core.count, cycle_price(energy_.leakage.core, unit_.clock_mhz));
    const std::uint64_t of_core =
        std::uint64_t{unit_.core.node_cache.size} + unit_.core.triangle_cache.size + unit_.core.texture_cache.size;
    const std::uint64_t bytes = of_core * unit_.core.count + unit_.selective.pixel_cache.size + unit_.memory.l2.size;
    add("static", "leakage.sram", cycles_ * bytes, cycle_price(energy_.leakage.sram, unit_.clock_mhz) / 1024);
  }

  const Counters counters_;
  const std::uint64_t cycles_;
  const hw::UnitConfig& unit_;
  const hw::EnergyConfig& energy_;
  std::vector<EnergyItem> items_;
};

}  // namespace

Energy energy_of(const Totals& totals, const hw::UnitConfig& unit) {
  Energy energy;
  energy.items = Model(totals, unit).items();
  energy.frames = totals.frames;
  energy.cycles = totals.cycles;
  energy.rays = totals.rays();
  energy.traced_pixels = totals.sampled + totals.traced;
  energy.clock_mhz = unit.clock_mhz;
  return energy;
}

}  // namespace artu::sim
