// Simulated time shared by the clock domains of one unit, in integer ticks.
//
// A tick is a common divisor of all clock periods, so every edge of every domain is a whole number of
// ticks, and "earlier", "later" and "at the same time" are exact across domains.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace artu::hw {

using Tick = std::uint64_t;
using Cycle = std::uint64_t;

inline constexpr std::uint64_t never = ~std::uint64_t{0};

class Channel;
class ClockDomain;

/// Looks at the blocks and channels between two edges.
class EdgeObserver {
 public:
  virtual ~EdgeObserver() = default;
  /// All that happens at `edge` has happened, and nothing will before `next`.
  virtual void settled(Tick edge, Tick next) = 0;
};

struct Timeline {
  Tick now = 0;         // the edge that is being worked on
  bool driven = false;  // a domain's process is running: wakes need no kernel event
  // An edge is worked on when SystemC's time is there, for a unit in a platform; otherwise ahead of it, which is
  // faster.
  bool in_step = false;
  std::function<void()> at_end;  // called when a block or the watchdog has ended the frame; may be called twice
  std::vector<ClockDomain*> domains;
  std::vector<const Channel*> channels;
  EdgeObserver* observer = nullptr;  // may be null; does not see the edge that ends the frame
};

}  // namespace artu::hw
