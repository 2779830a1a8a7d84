#include "sim/config/cross_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "sim/config/path_visitor.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using Places = std::map<std::string, std::string>;

/// The place of the first of these parameters that was given anywhere.
std::string place_of(const Places& places, std::initializer_list<std::string> paths) {
  for (const std::string& path : paths) {
    const auto found = places.find(path);
    if (found != places.end()) return found->second;
  }
  return "configuration";
}

/// Every group with a `size` and `ways` is a cache: a set must fit into it.
class CacheCheck : public PathVisitor {
 public:
  CacheCheck(std::uint32_t line, std::uint32_t l2_banks, const Places& places)
      : line_(line), l2_banks_(l2_banks), places_(places) {}

  void integer(const char* name, std::uint32_t& value, hw::IntegerRange, const char*, const char*) override {
    const std::string field = name;
    if (field == "size") size_ = value;
    if (field != "ways") return;
    const std::uint64_t set = std::uint64_t{value} * line_;
    if (set <= size_) return;
    // Every bank of the L2 has sets of its own, so what is right there depends on them as well.
    const std::uint32_t lines = size_ / line_, banks = path("ways") == "memory.l2.ways" ? l2_banks_ : 1;
    const std::string fewer = banks > lines ? fmt::format(" and memory.l2_banks = {}", lines) : "";
    const std::uint32_t ways = banks > lines ? 1 : lines / banks;
    const std::string right = ways == 1 ? "1 way" + fewer : fmt::format("at most {} ways", ways);
    throw InputError(place_of(places_, {path("ways"), path("size")}),
                     fmt::format("{} = {} needs {} bytes in lines of {}, more than {} = {}; {} would be right",
                                 path("ways"), value, set, line_, path("size"), size_, right));
  }
  void real(const char*, float&, hw::RealRange, const char*, const char*) override {}
  void flag(const char*, bool&, const char*) override {}
  void table(const char*, hw::TableValues, hw::IntegerRange, const char*, const char*) override {}
  void choice(const char*, unsigned&, const std::vector<const char*>&, const char*) override {}

 private:
  std::uint32_t line_, l2_banks_, size_ = 0;
  const Places& places_;
};

void check_selective(const hw::SelectiveConfig& selective, const Places& places) {
  if (selective.minimum > selective.maximum) {
    throw InputError(place_of(places, {"selective.minimum", "selective.maximum"}),
                     fmt::format("selective.minimum = {} is above selective.maximum = {}; at most {} would be right",
                                 selective.minimum, selective.maximum, selective.maximum));
  }
  if (selective.count == hw::Count::merged && selective.compare == hw::Compare::dynamic_vs_static) {
    throw InputError(place_of(places, {"selective.count", "selective.compare"}),
                     "selective.count = merged does not go with selective.compare = dynamic-vs-static, which needs the "
                     "two counts apart; count = per-class or compare = reference-count would be right");
  }
  if (selective.stride > selective.tile) {
    throw InputError(place_of(places, {"selective.stride", "selective.tile"}),
                     fmt::format("selective.stride = {} is above selective.tile = {}; at most {} would be right",
                                 selective.stride, selective.tile, selective.tile));
  }
}

/// A row that is opened between two refreshes must be read before the second, or the DRAM never answers: the slowest
/// way there is to end a row, refresh, and open another while the activate window is full.
void check_refresh(const hw::DramConfig& dram, const Places& places) {
  if (dram.refresh == hw::RefreshPolicy::none) return;
  const bool all = dram.refresh == hw::RefreshPolicy::all_bank;
  const char* const refresh = all ? "t_rfc" : "t_rfc_bank";
  const char* const precharge = all ? "t_rp_all" : "t_rp";
  const std::uint32_t needed = (all ? dram.t_rfc : dram.t_rfc_bank) + (all ? dram.t_rp_all : dram.t_rp) + dram.t_ras +
                               dram.t_rcd + std::max(dram.t_faw, dram.t_rrd);
  if (dram.t_refi > needed) return;
  const std::string group = "memory.dram.";
  throw InputError(
      place_of(places, {group + "t_refi", group + refresh, group + precharge, group + "t_ras", group + "t_rcd",
                        group + "t_faw", group + "t_rrd", group + "refresh"}),
      fmt::format("memory.dram.t_refi = {} leaves no time between refreshes: {} + {} + t_ras + t_rcd + the "
                  "longer of t_faw and t_rrd is {}; at least {} would be right",
                  dram.t_refi, refresh, precharge, needed, needed + 1));
}

}  // namespace

void cross_check(const hw::UnitConfig& unit, const Places& places) {
  check_selective(unit.selective, places);
  const hw::DramConfig& dram = unit.memory.dram;
  const auto below = [&](const char* low, std::uint32_t a, const char* high, std::uint32_t b, bool equal) {
    if (a < b || (equal && a == b)) return;
    const std::string first = std::string("memory.dram.") + low, second = std::string("memory.dram.") + high;
    throw InputError(place_of(places, {first, second}),
                     fmt::format("{} = {} is {} {} = {}; at most {} would be right", first, a,
                                 a == b ? "not below" : "above", second, b, equal ? b : b - 1));
  };
  below("bank_groups", dram.bank_groups, "banks", dram.banks, true);
  below("write_low", dram.write_low, "write_high", dram.write_high, false);
  below("write_high", dram.write_high, "write_queue_depth", dram.write_queue_depth, true);
  check_refresh(dram, places);
  constexpr std::uint32_t spilled_at_once = 8;
  if (unit.core.stack_overflow == hw::StackOverflow::spill && unit.core.stack_entries < spilled_at_once) {
    throw InputError(
        place_of(places, {"core.stack_entries", "core.stack_overflow"}),
        fmt::format("core.stack_entries = {} is less than the line of {} entries that is spilled at a time; "
                    "at least {} would be right",
                    unit.core.stack_entries, spilled_at_once, spilled_at_once));
  }
  const std::uint32_t banks = unit.memory.l2_banks;
  const hw::TreeBuilderConfig& builder = unit.tree_builder;
  const bool morton = builder.algorithm == hw::BuildAlgorithm::morton;
  if (unit.accel.dynamic_kind == hw::TreeKind::kd && (morton || builder.refit)) {
    const std::string parameter = morton ? "tree_builder.algorithm" : "tree_builder.refit";
    throw InputError(place_of(places, {parameter, "accel.dynamic.kind"}),
                     fmt::format("{} = {} does not go with accel.dynamic.kind = kd; a kd-tree is built anew by sah, so "
                                 "{} or a BVH would be right",
                                 parameter, morton ? "morton" : "true", morton ? "sah" : "false"));
  }
  hw::UnitConfig copy = unit;
  CacheCheck caches(unit.memory.line, banks, places);
  copy.visit(caches);
  const std::uint64_t bank_set = std::uint64_t{banks} * unit.memory.l2.ways * unit.memory.line;
  if (bank_set > unit.memory.l2.size) {
    std::uint32_t right = banks;
    while (right * unit.memory.l2.ways * unit.memory.line > unit.memory.l2.size) right /= 2;
    throw InputError(place_of(places, {"memory.l2_banks", "memory.l2.size", "memory.l2.ways"}),
                     fmt::format("memory.l2_banks = {} with a set of {} ways each need {} bytes, more than "
                                 "memory.l2.size = {}; at most {} banks would be right",
                                 banks, unit.memory.l2.ways, bank_set, unit.memory.l2.size, right));
  }
}

}  // namespace artu::sim
