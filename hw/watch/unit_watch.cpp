#include "hw/watch/unit_watch.h"

#include <algorithm>

namespace artu::hw {

namespace {

Tick tick_of(Cycle cycle, Tick period) { return cycle > never / period ? never : cycle * period; }

}  // namespace

RayStageName name_of(RayStage stage) {
  static constexpr RayStageName names[ray_stages] = {
      {"set-up", "Su"},         {"queue for traversal", "Qt"},    {"traversal", "Tr"},
      {"node fetch", "Nf"},     {"queue for intersection", "Qi"}, {"intersection", "In"},
      {"triangle fetch", "Tf"}, {"queue for hit point", "Qh"},    {"hit point", "Hp"},
      {"surface fetch", "Sf"},  {"queue for shading", "Qs"},      {"shading", "Sh"},
      {"texture fetch", "Xf"},  {"queue for set-up", "Qg"}};
  return names[static_cast<std::size_t>(stage)];
}

UnitWatch::UnitWatch(RayTracingUnit& unit, std::vector<ActivitySink*> sinks, const ActivityWindow& window)
    : unit_(unit),
      sinks_(std::move(sinks)),
      from_(tick_of(window.from, unit.clock.period())),
      to_(tick_of(window.to, unit.clock.period())) {
  const Timeline& timeline = unit.clock.timeline();
  // Not the sampler's domain: it is no part of the unit.
  for (const ClockDomain* domain : {&unit.clock, &unit.dram_clock}) {
    for (const Block* block : domain->blocks()) {
      blocks_.push_back({block, domain->period()});
      layout_.blocks.push_back({block->path(), domain->period()});
    }
  }
  for (const Channel* channel : timeline.channels) {
    channels_.push_back(channel);
    layout_.channels.push_back({channel->name(), channel->capacity()});
  }
  levels_.resize(channels_.size());
  for (std::size_t core = 0; core < unit.cores.size(); ++core) {
    cores_.emplace_back(unit.cores[core]->ray_paths(), static_cast<std::uint32_t>(core));
  }
  layout_.cores = static_cast<std::uint32_t>(unit.cores.size());
  layout_.unit_period = unit.clock.period();
  layout_.clock_mhz = unit.clock_mhz();
}

void UnitWatch::begin_frame() {
  for (RayWatch& core : cores_) core.reset();
  rays_ = 0;
  open_ = closed_ = false;
}

void UnitWatch::look_at_rays(Tick edge) {
  if (edge % layout_.unit_period != 0) return;
  const Cycle cycle = edge / layout_.unit_period;
  for (RayWatch& core : cores_) core.look(cycle, edge, open_ ? sinks_ : nobody_, rays_);
}

/// What has changed at the edge.
void UnitWatch::look(Tick edge) {
  if (const unsigned phase = unit_.control_unit.phase(); phase != phase_) {
    phase_ = phase;
    tell([&](ActivitySink& sink) { sink.phase(edge, phase); });
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const State state = state_at(blocks_[i], edge);
    if (state == blocks_[i].state) continue;
    blocks_[i].state = state;
    tell([&](ActivitySink& sink) { sink.state(edge, i, state); });
  }
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const std::uint32_t level = channels_[i]->size();
    if (level == levels_[i]) continue;
    levels_[i] = level;
    tell([&](ActivitySink& sink) { sink.level(edge, i, level); });
  }
}

/// What blocks have said of cycles before the next edge.
void UnitWatch::look_ahead(Tick edge, Tick next) {
  later_.clear();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const Tick since = blocks_[i].block->state_since() * blocks_[i].period;
    if (since > edge && since < next) later_.push_back({since, i, blocks_[i].block->state()});
  }
  std::stable_sort(later_.begin(), later_.end(), [](const Later& a, const Later& b) { return a.tick < b.tick; });
  for (const Later& change : later_) {
    if (blocks_[change.block].state == change.state) continue;
    blocks_[change.block].state = change.state;
    tell([&](ActivitySink& sink) { sink.state(change.tick, change.block, change.state); });
  }
}

void UnitWatch::open(Tick tick) {
  open_ = true;
  phase_ = unit_.control_unit.phase();
  tell([&](ActivitySink& sink) {
    sink.begin(layout_, tick);
    sink.phase(tick, phase_);
  });
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    blocks_[i].state = state_at(blocks_[i], tick);
    tell([&](ActivitySink& sink) { sink.state(tick, i, blocks_[i].state); });
  }
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    levels_[i] = channels_[i]->size();
    tell([&](ActivitySink& sink) { sink.level(tick, i, levels_[i]); });
  }
  for (const RayWatch& core : cores_) core.open(tick, sinks_);
}

void UnitWatch::close(Tick tick) {
  closed_ = true;
  for (const RayWatch& core : cores_) core.close(tick, sinks_);
  tell([&](ActivitySink& sink) { sink.end(tick); });
}

void UnitWatch::settled(Tick edge, Tick next) {
  if (closed_) return;
  if (open_) {
    look(edge);
    look_at_rays(edge);
  } else {
    look_at_rays(edge);
    if (next <= from_) return;
    open(std::max(edge, from_));
  }
  look_ahead(std::max(edge, from_), std::min(next, to_));
  if (next >= to_) close(to_);
}

void UnitWatch::end_frame(Tick end) {
  if (closed_) return;
  if (!open_) {  // the window lies behind the frame
    closed_ = true;
    tell([&](ActivitySink& sink) {
      sink.begin(layout_, end);
      sink.end(end);
    });
    return;
  }
  // The edge that ends the frame is not part of it: of what happened there only that the channels are empty is told.
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (levels_[i] == channels_[i]->size()) continue;
    levels_[i] = channels_[i]->size();
    tell([&](ActivitySink& sink) { sink.level(end, i, levels_[i]); });
  }
  close(end);
}

}  // namespace artu::hw
