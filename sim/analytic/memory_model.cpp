#include "sim/analytic/memory_model.h"

#include "hw/memory/dram_channel.h"

namespace artu::sim {
namespace {

// While a line is on its way, further misses on it join the first: about the latency of a miss, in cycles.
constexpr std::uint64_t l1_latency = 40, l2_latency = 30;

}  // namespace

MemoryCounts& MemoryCounts::operator-=(const MemoryCounts& other) {
  for (std::size_t i = 0; i < clients; ++i) {
    client[i].requests -= other.client[i].requests;
    client[i].misses -= other.client[i].misses;
    client[i].merged -= other.client[i].merged;
  }
  l2_reads -= other.l2_reads;
  l2_writes -= other.l2_writes;
  l2_fills -= other.l2_fills;
  l2_merged -= other.l2_merged;
  l2_unfetched -= other.l2_unfetched;
  l2_write_backs -= other.l2_write_backs;
  row_misses -= other.row_misses;
  return *this;
}

MemoryModel::MemoryModel(const hw::UnitConfig& config)
    : config_(config),
      l1_{std::vector<SampledCache>(config.core.count, {config.core.node_cache, config.core.node_cache.size}),
          std::vector<SampledCache>(config.core.count, {config.core.triangle_cache, config.core.triangle_cache.size}),
          std::vector<SampledCache>(config.core.count, {config.core.texture_cache, config.core.texture_cache.size})},
      pixel_(config.selective.pixel_cache, config.selective.pixel_cache.size),
      l2_(config.memory.l2, config.memory.l2.size),
      open_rows_(std::size_t{config.memory.dram.channels} * config.memory.dram.banks, ~std::uint64_t{0}) {}

void MemoryModel::read(Client client, std::uint32_t core, std::uint64_t line, std::uint64_t now) {
  MemoryCounts::OfClient& count = counts_.client[static_cast<std::size_t>(client)];
  ++count.requests;
  if (client != Client::builder) {
    SampledCache& cache = client == Client::pixel ? pixel_ : l1_[static_cast<std::size_t>(client)][core];
    const SampledCache::Look look = cache.access(line, false, now, l1_latency);
    count.merged += look.merged;
    if (look.hit) return;
  }
  ++count.misses;
  // The builder asks in order, without time.
  below(line, false, false, now, client == Client::builder ? 0 : l2_latency);
}

void MemoryModel::write(Client client, std::uint64_t line, bool whole, std::uint64_t now) {
  ++counts_.client[static_cast<std::size_t>(client)].requests;
  if (client != Client::builder) pixel_.drop(line);
  below(line, true, whole, now, client == Client::builder ? 0 : l2_latency);
}

void MemoryModel::below(std::uint64_t line, bool write, bool whole, std::uint64_t now, std::uint64_t latency) {
  ++(write ? counts_.l2_writes : counts_.l2_reads);
  // A whole line is there as soon as it is written: it is filled at 0, long ago.
  const SampledCache::Look look = l2_.access(line, write, whole ? 0 : now, latency);
  counts_.l2_merged += look.merged && !whole;
  if (look.hit) return;
  if (look.evicted_dirty) {
    ++counts_.l2_write_backs;
    dram(l2_.evicted());
  }
  if (whole) {
    ++counts_.l2_unfetched;
    return;
  }
  ++counts_.l2_fills;
  dram(line);
}

void MemoryModel::dram(std::uint64_t line) {
  const hw::DramPlace place = hw::place_of_line(config_.memory.dram, line);
  std::uint64_t& open = open_rows_[std::size_t{place.channel} * config_.memory.dram.banks + place.bank];
  counts_.row_misses += open != place.row;
  open = place.row;
}

}  // namespace artu::sim
