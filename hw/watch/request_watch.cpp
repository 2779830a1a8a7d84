#include "hw/watch/request_watch.h"

#include <algorithm>

namespace artu::hw {

RequestWatch::RequestWatch(RayTracingUnit& unit, RequestSink& sink) : sink_(sink), period_(unit.clock.period()) {
  for (const Block* block : unit.clock.blocks()) {
    if (dynamic_cast<const Cache*>(block) != nullptr) caches_.push_back(block->path());
  }
  const auto number_of = [this](const Block* block) {
    return static_cast<std::size_t>(std::find(caches_.begin(), caches_.end(), block->path()) - caches_.begin());
  };
  for (const Channel* channel : unit.clock.timeline().channels) {
    const bool to_cache = dynamic_cast<const Cache*>(channel->consumer()) != nullptr;
    if (const auto* requests = dynamic_cast<const Fifo<MemoryRequest>*>(channel); requests != nullptr && to_cache) {
      requests_.push_back({requests, number_of(channel->consumer())});
    }
    if (const auto* written = dynamic_cast<const Fifo<LineWritten>*>(channel); written != nullptr && to_cache) {
      written_.push_back({written, number_of(channel->consumer())});
    }
    if (const auto* passes = dynamic_cast<const Fifo<PassCommand>*>(channel);
        passes != nullptr && channel->consumer() == &unit.candidate_pixel_extractor) {
      passes_.push_back({passes, number_of(&unit.pixel_cache)});
    }
  }
  unit.clock.timeline().observer = this;
}

/// Once for each token that was taken from the channel since the last look.
template <class Token, class See>
void RequestWatch::popped(Watched<Token>& watched, See see) {
  for (; watched.seen != watched.channel->pops(); ++watched.seen) see(watched.channel->pushed(watched.seen));
}

void RequestWatch::begin_frame() {
  for (auto& watched : requests_) watched.seen = 0;
  for (auto& watched : written_) watched.seen = 0;
  for (auto& watched : passes_) watched.seen = 0;
  sink_.begin_frame(caches_);
}

void RequestWatch::settled(Tick edge, Tick) {
  // A cache forgets a line before it looks at the requests of the cycle, and serves one of them.
  for (auto& watched : passes_) popped(watched, [&](const PassCommand&) { sink_.forget_all(watched.cache); });
  for (auto& watched : written_) popped(watched, [&](const LineWritten& w) { sink_.forget(watched.cache, w.line); });
  for (auto& watched : requests_) {
    popped(watched, [&](const MemoryRequest& request) { sink_.request(watched.cache, edge / period_, request); });
  }
}

}  // namespace artu::hw
