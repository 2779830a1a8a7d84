#include "sim/analytic/sampled_cache.h"

#include <algorithm>

namespace artu::sim {

SampledCache::SampledCache(const hw::CacheConfig& config, std::uint64_t size) : hashed_(config.hashed) {
  const std::uint64_t lines = std::max<std::uint64_t>(size / 64, 1);
  sets_ = std::max<std::uint64_t>(lines / config.ways / sample_factor, 1);
  // A cache of fewer sets than the sample tells apart: fewer ways stand for it.
  ways_ = std::max<std::uint64_t>(std::min<std::uint64_t>(config.ways, lines / sample_factor / sets_), 1);
  set_shift_ = sets_ > 1 ? static_cast<unsigned>(__builtin_ctzll(sets_)) : 1;
  entries_.resize(sets_ * ways_);
}

void SampledCache::reset() { std::fill(entries_.begin(), entries_.end(), Entry{}); }

SampledCache::Entry* SampledCache::set_of(std::uint64_t line) {
  const std::uint64_t index = line >> sample_shift;
  const std::uint64_t set = hashed_ ? index ^ (index >> set_shift_) ^ (index >> (2 * set_shift_)) : index;
  return &entries_[(set & (sets_ - 1)) * ways_];
}

SampledCache::Look SampledCache::access(std::uint64_t line, bool write, std::uint64_t now, std::uint64_t latency) {
  Entry* set = set_of(line);
  Look look;
  const std::uint64_t clean = (line + 1) << 1;
  std::size_t way = 0;
  while (way < ways_ && (set[way].tag & ~std::uint64_t{1}) != clean) ++way;
  Entry entry{clean, now};
  if (way < ways_) {
    entry = set[way];
    look.hit = true;
    look.merged = now < entry.filled + latency;
  } else {
    --way;
    look.evicted_dirty = (set[way].tag & 1) != 0;
    evicted_ = (set[way].tag >> 1) - 1;
  }
  if (write) entry.tag |= 1;
  for (; way != 0; --way) set[way] = set[way - 1];
  set[0] = entry;
  return look;
}

void SampledCache::drop(std::uint64_t line) {
  Entry* set = set_of(line);
  for (std::size_t way = 0; way < ways_; ++way) {
    if ((set[way].tag >> 1) == line + 1) set[way] = {};
  }
}

std::uint64_t SampledCache::dirty_lines() const {
  return static_cast<std::uint64_t>(
      std::count_if(entries_.begin(), entries_.end(), [](const Entry& e) { return (e.tag & 1) != 0; }));
}

}  // namespace artu::sim
