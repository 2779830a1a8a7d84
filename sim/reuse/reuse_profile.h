// How often lines are used again, for every kind of cache: the stack distances of its requests, and its working set.
// Sources: Mattson et al., IBM Systems Journal 9(2), 1970; Denning, CACM 11(5), 1968 (working set).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "hw/unit_config.h"
#include "hw/watch/request_sink.h"
#include "sim/reuse/stack_distance.h"

namespace artu::sim {

/// Distinct lines that the caches of a kind were asked for in a window of a frame.
struct WorkingSet {
  std::uint32_t frame = 0;
  std::uint64_t cycle = 0, requests = 0;  // where it begins; of all caches of the kind
  double lines = 0;                       // mean of the caches
  std::uint64_t largest = 0;
};

/// Of all caches of a kind, each with a stack of its own; the L2's banks are one cache.  Of one frame, or of several,
/// each of which begins with empty caches.
struct CacheReuse {
  std::string name;
  std::uint64_t caches = 0;
  std::uint64_t lines = 0;  // that one of them has as it is configured
  std::uint64_t requests = 0, first_uses = 0;
  std::vector<std::uint64_t> distances;  // requests by stack distance
  std::vector<WorkingSet> windows;

  /// Of caches with so many lines, the least recently used one replaced, every line allowed everywhere.
  std::uint64_t misses(std::uint64_t size) const;
  /// The fewest lines with which only first uses miss.
  std::uint64_t enough() const { return distances.size(); }
};

/// `frame` is later than those of `sum`, or `sum` is empty.
void add(std::vector<CacheReuse>& sum, const std::vector<CacheReuse>& frame);

/// The profile of one frame at a time.
class ReuseProfile : public hw::RequestSink {
 public:
  /// Of the unit's caches; `window` in cycles.
  ReuseProfile(const hw::UnitConfig& unit, std::uint64_t window) : unit_(unit), window_(window) {}

  void begin_frame(const std::vector<std::string>& caches) override;
  void request(std::size_t cache, hw::Cycle cycle, const hw::MemoryRequest& request) override;
  void forget(std::size_t cache, hw::Address line) override;
  void forget_all(std::size_t cache) override;

  /// After the frame of this index; kinds in the order in which their first caches come.
  std::vector<CacheReuse> end_frame(std::uint32_t index, std::uint64_t cycles);

 private:
  struct Stack {
    std::size_t kind = 0;
    StackDistance distance;
    std::unordered_map<std::uint64_t, std::uint64_t> used;  // by line the number of the last window, and 1
    std::vector<std::uint64_t> lines, requests;             // by window of this frame
  };

  void make_stacks(const std::vector<std::string>& caches);

  const hw::UnitConfig unit_;
  const std::uint64_t window_;
  std::vector<CacheReuse> kinds_;
  std::vector<Stack> stacks_;
  std::vector<std::size_t> stack_of_;  // by number of the cache
};

/// "core3.node_cache" -> "node_cache", "l2_bank1" -> "l2".
std::string kind_of_cache(const std::string& path);

}  // namespace artu::sim
