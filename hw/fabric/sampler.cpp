#include "hw/fabric/sampler.h"

#include <algorithm>

#include "hw/fabric/fifo.h"

namespace artu::hw {

Sampler::Sampler(sc_core::sc_module_name name, ClockDomain& domain, Tick unit_period, std::vector<const Block*> blocks,
                 std::vector<const Channel*> channels, std::vector<Count> counts)
    : Block(name, domain),
      unit_period_(unit_period),
      blocks_(std::move(blocks)),
      channels_(std::move(channels)),
      counts_(std::move(counts)) {
  for (const Block* block : blocks_) timeline_.blocks.push_back(block->path());
  for (const Channel* channel : channels_) {
    timeline_.channels.push_back(channel->name());
    timeline_.capacities.push_back(channel->capacity());
  }
  for (const Count& count : counts_) timeline_.counts.push_back(count.name);
}

void Sampler::reset() {
  timeline_.interval = first_interval;
  timeline_.samples.clear();
  timeline_.phases.clear();
  next_ = 1;
}

Snapshot Sampler::states_at(Cycle cycle) const {
  Snapshot snapshot;
  snapshot.at = cycle;
  snapshot.states.reserve(blocks_.size() * state_count);
  for (const Block* block : blocks_) {
    const Cycle own = cycle * unit_period_ / block->domain().period();
    for (std::size_t s = 0; s < state_count; ++s) {
      snapshot.states.push_back(block->cycles_before(static_cast<State>(s), own));
    }
  }
  return snapshot;
}

Snapshot Sampler::look(Cycle cycle) const {
  Snapshot snapshot = states_at(cycle);
  for (const Channel* channel : channels_) snapshot.levels.push_back(channel->size());
  for (const Count& count : counts_) snapshot.counts.push_back(count.value());
  return snapshot;
}

void Sampler::phase_begins(unsigned phase, Cycle cycle) { timeline_.phases.push_back({phase, states_at(cycle)}); }

void Sampler::finish(Cycle cycles) { timeline_.samples.push_back(look(cycles)); }

Activity Sampler::tick(Cycle now) {
  if (now >= next_) {
    timeline_.samples.push_back(look(now * first_interval));
    if (timeline_.samples.size() == maximum_looks) {
      timeline_.interval *= 2;
      std::size_t kept = 0;
      for (std::size_t i = 1; i < maximum_looks; i += 2) std::swap(timeline_.samples[kept++], timeline_.samples[i]);
      timeline_.samples.resize(kept);
    }
    next_ = timeline_.samples.back().at / first_interval + timeline_.interval / first_interval;
  }
  // Where all others sleep for good the unit is stuck, and must be found so.
  const auto& domains = domain().timeline().domains;
  const bool alive = std::any_of(domains.begin(), domains.end(),
                                 [this](const ClockDomain* other) { return other != &domain() && !other->asleep(); });
  return {State::idle, alive ? next_ : never};
}

}  // namespace artu::hw
