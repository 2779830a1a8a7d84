// Which requests a cache would miss, looked up without time: tags of every set that a sample of the lines can be in.
//
// Sets are independent of each other, so the misses of a quarter of them are a quarter of all (set sampling: Puzak
// 1985; Kessler, Hill and Wood, IEEE ToC 1994).  The sample is the lines whose number has the same two last bits; that
// is whole sets of a cache whose set is the line's number modulo their count, and a whole bank of four.  The least
// recently used line goes, whatever the unit's replacement.
#pragma once

#include <cstdint>
#include <vector>

#include "hw/memory/layout.h"

namespace artu::sim {

/// Of every so many lines one is looked up.
inline constexpr unsigned sample_shift = 2;
inline constexpr std::uint64_t sample_factor = std::uint64_t{1} << sample_shift;
inline bool is_sampled(std::uint64_t line) { return (line & (sample_factor - 1)) == 1; }

class SampledCache {
 public:
  /// What became of a request: `merged` are hits on a line that was asked for less than `latency` cycles ago.
  struct Look {
    bool hit = false, merged = false;
    bool evicted_dirty = false;
  };

  SampledCache(const hw::CacheConfig& config, std::uint64_t size);
  void reset();

  /// Of a sampled line, by its number in memory.
  Look access(std::uint64_t line, bool write, std::uint64_t now, std::uint64_t latency);
  /// The line that the last miss put out, by its number.
  std::uint64_t evicted() const { return evicted_; }
  /// Forgets the line.
  void drop(std::uint64_t line);
  /// Of the sample.
  std::uint64_t dirty_lines() const;

 private:
  struct Entry {
    std::uint64_t tag = 0;  // line + 1, times 2, and 1 if it is dirty; 0 holds nothing
    std::uint64_t filled = 0;
  };
  Entry* set_of(std::uint64_t line);

  const bool hashed_;
  std::size_t ways_, sets_;
  unsigned set_shift_;
  std::uint64_t evicted_ = 0;
  std::vector<Entry> entries_;  // of each set, the most recently used first
};

}  // namespace artu::sim
