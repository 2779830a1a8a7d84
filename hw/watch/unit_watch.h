// Looks at the unit between its edges and tells what has changed.  It reads states and counts that the blocks and the
// channels have anyway: where nobody watches nothing is done, and watching changes nothing.
#pragma once

#include <vector>

#include "hw/ray_tracing_unit.h"
#include "hw/watch/ray_watch.h"

namespace artu::hw {

class UnitWatch : public EdgeObserver {
 public:
  /// Of the frames that the unit runs from now on; both the unit and the sinks must outlive it.  The unit tells the
  /// end of each frame.
  UnitWatch(RayTracingUnit& unit, std::vector<ActivitySink*> sinks, const ActivityWindow& window);

  void begin_frame();
  void settled(Tick edge, Tick next) override;
  void end_frame(Tick end);

 private:
  struct SeenBlock {
    const Block* block;
    Tick period;
    State state = State::idle;
  };
  struct Later {
    Tick tick;
    std::size_t block;
    State state;
  };
  State state_at(const SeenBlock& seen, Tick tick) const { return seen.block->state_in(tick / seen.period); }
  void look_at_rays(Tick edge);
  void look(Tick edge);
  void look_ahead(Tick edge, Tick next);
  void open(Tick edge);
  void close(Tick tick);
  template <class Tell>
  void tell(Tell tell) const {
    for (ActivitySink* sink : sinks_) tell(*sink);
  }

  const RayTracingUnit& unit_;
  const std::vector<ActivitySink*> sinks_, nobody_;
  const Tick from_, to_;
  ActivityLayout layout_;
  std::vector<SeenBlock> blocks_;
  std::vector<const Channel*> channels_;
  std::vector<std::uint32_t> levels_;
  std::vector<RayWatch> cores_;
  std::vector<Later> later_;
  unsigned phase_ = 0;
  std::uint64_t rays_ = 0;
  bool open_ = false, closed_ = false;
};

}  // namespace artu::hw
