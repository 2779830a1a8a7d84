// Follows the rays of a core from block to block: by the tokens of its channels, so that no block knows of it.
#pragma once

#include <vector>

#include "hw/ray_core/ray_core.h"
#include "hw/watch/activity.h"

namespace artu::hw {

class RayWatch {
 public:
  RayWatch(const RayPaths& paths, std::uint32_t core);

  /// At the beginning of a frame.
  void reset();
  /// What the core did in the cycle, which is over; `sinks` are told of it.  `number` is the next ray's.
  void look(Cycle cycle, Tick tick, const std::vector<ActivitySink*>& sinks, std::uint64_t& number);
  /// Tells of the rays in flight, as if they began.
  void open(Tick tick, const std::vector<ActivitySink*>& sinks) const;
  /// Tells that they are cut.
  void close(Tick tick, const std::vector<ActivitySink*>& sinks) const;

 private:
  struct Followed {
    RayInFlight ray;
    bool in_flight = false, changed = false;
    std::uint32_t fetching = 0;         // lines
    RayStage stage = RayStage::set_up;  // without regard to fetching
    RayStage told = RayStage::set_up;
    RayStage then = RayStage::set_up;  // from then_at on
    Cycle then_at = never;
  };
  struct Seen {
    std::uint32_t pops = 0, pushes = 0;
  };
  template <class Token, class See>
  void popped(const Fifo<Token>& channel, Seen& seen, See see);
  template <class Token, class See>
  void pushed(const Fifo<Token>& channel, Seen& seen, See see);
  void pops(Tick tick, const std::vector<ActivitySink*>& sinks);
  void pushes(Cycle cycle, Tick tick, const std::vector<ActivitySink*>& sinks, std::uint64_t& number);
  void enter(Slot slot, RayStage stage);
  void pass(Slot slot, RayStage until, RayStage then, Cycle at);
  void ask(Slot slot);
  void answer(Slot slot);
  void begin(Slot slot, Tick tick, const std::vector<ActivitySink*>& sinks, std::uint64_t& number);
  void end(Slot slot, Tick tick, const std::vector<ActivitySink*>& sinks);
  void change(Slot slot);

  const RayPaths paths_;
  const std::uint32_t core_;
  std::vector<Followed> rays_;  // by slot
  std::vector<Slot> changed_;
  std::vector<Slot> passing_;  // with a then_at
  Seen primary_, others_, tested_, hits_, misses_, shadows_, surfaces_, next_rays_, freed_, leaves_;
  Seen node_requests_, node_responses_, triangle_requests_, triangle_responses_, attribute_requests_,
      attribute_responses_, texel_requests_, texel_responses_;
};

}  // namespace artu::hw
