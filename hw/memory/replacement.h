// Which line of a full cache set goes: least recently used, tree pseudo-LRU, or random.
//
// Ways that hold nothing are filled first, from way 0 on; that is the cache's business (it knows its tags).
#pragma once

#include <cstdint>
#include <vector>

#include "hw/unit_config.h"

namespace artu::hw {

class Replacement {
 public:
  /// `ways` is a power of two of at most 64.
  Replacement(ReplacementPolicy policy, std::size_t sets, std::uint32_t ways, std::uint32_t seed);
  void reset();

  /// A line was used or installed.
  void touch(std::size_t set, std::uint32_t way) {
    if (policy_ == ReplacementPolicy::lru) {
      used_[set * ways_ + way] = ++clock_;
    } else if (policy_ == ReplacementPolicy::plru) {
      point_away(set, way);
    }
  }
  /// The way that goes next; the same until something is touched or `replaced`.
  std::uint32_t victim(std::size_t set) const;
  /// The victim has gone: the next random one is another.
  void replaced() { state_ = next(state_); }

 private:
  void point_away(std::size_t set, std::uint32_t way);
  static std::uint64_t next(std::uint64_t state);

  const ReplacementPolicy policy_;
  const std::uint32_t ways_;
  const std::uint64_t seed_;
  std::uint64_t clock_ = 0, state_ = 0;
  std::vector<std::uint64_t> used_;  // LRU: time by line.  Pseudo-LRU: bits by set, 1 where the right half is older
};

}  // namespace artu::hw
