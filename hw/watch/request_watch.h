// Tells which lines the caches are asked for, in the order in which they serve the requests.  It looks at the caches'
// channels between two edges, as UnitWatch does: where nobody asks nothing is done.
#pragma once

#include <string>
#include <vector>

#include "hw/ray_tracing_unit.h"
#include "hw/watch/request_sink.h"

namespace artu::hw {

class RequestWatch : public EdgeObserver {
 public:
  /// Of the frames that the unit runs from now on; both unit and sink must outlive it.
  RequestWatch(RayTracingUnit& unit, RequestSink& sink);

  /// Before the unit runs a frame.
  void begin_frame();
  void settled(Tick edge, Tick next) override;

 private:
  template <class Token>
  struct Watched {
    const Fifo<Token>* channel;
    std::size_t cache;
    std::uint32_t seen = 0;
  };
  template <class Token, class See>
  static void popped(Watched<Token>& watched, See see);

  RequestSink& sink_;
  std::vector<std::string> caches_;  // in the order of the reports
  const Tick period_;
  std::vector<Watched<MemoryRequest>> requests_;
  std::vector<Watched<LineWritten>> written_;
  std::vector<Watched<PassCommand>> passes_;  // begins one, whose extractor has the pixel cache forget all
};

}  // namespace artu::hw
