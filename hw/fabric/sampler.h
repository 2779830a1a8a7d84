// Looks at the unit at equal distances of a frame: what its blocks have done so far, how full its channels are.
//
// No part of the chip, and there only when asked for.  It has a clock domain of its own that is worked on after all
// others, so that it sees every cycle as its blocks have left it: the same in event and clocked mode and in any order
// of the blocks.  There is no room for a long frame in full: when the looks are too many every second one is
// forgotten and the distance doubles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hw/fabric/clock_domain.h"

namespace artu::hw {

class Channel;

/// The unit when `at` of its cycles had passed.
struct Snapshot {
  Cycle at = 0;
  std::vector<std::uint64_t> states;  // of each block state_count, in cycles of its clock, so far
  std::vector<std::uint32_t> levels;  // of each channel
  std::vector<std::uint64_t> counts;  // so far
};

/// A frame from cycle to cycle.  Blocks, channels and counts in the order of every snapshot.
struct FrameTimeline {
  Cycle interval = 0;  // 0: nobody looked
  std::vector<std::string> blocks, channels, counts;
  std::vector<std::uint32_t> capacities;  // of the channels
  std::vector<Snapshot> samples;          // the last one at the end of the frame
  struct Phase {
    unsigned phase;  // that begins
    Snapshot at;     // states only
  };
  std::vector<Phase> phases;
};

class Sampler : public Block {
 public:
  static constexpr Cycle first_interval = 16;        // cycles of the unit
  static constexpr std::size_t maximum_looks = 300;  // half of them at least, in frames that are long enough

  struct Count {
    std::string name;
    std::function<std::uint64_t()> value;
  };
  /// `domain` has a period of first_interval cycles of the unit's clock; ticks of the two clocks: `unit_period`,
  /// `dram_period`.  `blocks` may be of both.
  Sampler(sc_core::sc_module_name name, ClockDomain& domain, Tick unit_period, std::vector<const Block*> blocks,
          std::vector<const Channel*> channels, std::vector<Count> counts);

  /// A phase of the frame begins in this cycle of the unit.
  void phase_begins(unsigned phase, Cycle cycle);
  /// The frame took this many cycles; call before the domains are told.
  void finish(Cycle cycles);
  const FrameTimeline& timeline() const { return timeline_; }

  void reset() override;

 private:
  Activity tick(Cycle now) override;
  Snapshot states_at(Cycle cycle) const;
  Snapshot look(Cycle cycle) const;

  const Tick unit_period_;
  const std::vector<const Block*> blocks_;
  const std::vector<const Channel*> channels_;
  const std::vector<Count> counts_;
  FrameTimeline timeline_;
  Cycle next_ = 0;  // look, in cycles of the domain
};

}  // namespace artu::hw
