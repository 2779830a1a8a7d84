#include "sim/viewers/konata.h"

#include <fmt/format.h>

#include <iterator>

namespace artu::sim {

namespace {

const char* const kinds[hw::ray_kinds] = {"primary", "shadow", "reflection", "refraction"};

}  // namespace

void KonataTrace::begin(const hw::ActivityLayout& layout, hw::Tick tick) {
  unit_period_ = layout.unit_period;
  begin_ = tick;
  cycle_ = tick / unit_period_;
  ids_ = retired_ = 0;
  lines_.clear();
  parents_.clear();
  write(fmt::format("Kanata\t0004\nC=\t{}\n", cycle_));
}

/// Commands belong to the cycle that the last C has come to.
void KonataTrace::advance(hw::Tick tick) {
  const hw::Cycle cycle = tick / unit_period_;
  if (cycle == cycle_) return;
  fmt::format_to(std::back_inserter(text_), "C\t{}\n", cycle - cycle_);
  cycle_ = cycle;
  parents_.clear();
  flush();
}

void KonataTrace::flush() {
  write(text_);
  text_.clear();
}

void KonataTrace::ray_begins(hw::Tick tick, const hw::RayInFlight& ray) {
  advance(tick);
  const std::uint64_t id = ids_++;
  lines_[ray.number] = {id};
  auto out = std::back_inserter(text_);
  fmt::format_to(out, "I\t{}\t{}\t{}\n", id, ray.number, ray.core);
  fmt::format_to(out, "L\t{}\t0\t{}: {} ({}, {})\n", id, ray.number, kinds[static_cast<std::size_t>(ray.kind)], ray.x,
                 ray.y);
  fmt::format_to(out, "L\t{}\t1\tcore {}, context {}\n", id, ray.core, ray.slot);
  // The viewer draws an arrow from the ray of the same pixel that this one follows.
  if (const auto parent = parents_.find(ray.before); parent != parents_.end()) {
    fmt::format_to(out, "W\t{}\t{}\t0\n", id, parent->second);
  }
}

void KonataTrace::ray_enters(hw::Tick tick, const hw::RayInFlight& ray, hw::RayStage stage) {
  advance(tick);
  Line& line = lines_[ray.number];
  auto out = std::back_inserter(text_);
  if (line.begun) fmt::format_to(out, "E\t{}\t0\t{}\n", line.id, name_of(line.stage).abbreviation);
  fmt::format_to(out, "S\t{}\t0\t{}\n", line.id, name_of(stage).abbreviation);
  line.stage = stage;
  line.begun = true;
}

void KonataTrace::ray_ends(hw::Tick tick, const hw::RayInFlight& ray, bool cut) {
  advance(tick);
  const Line line = lines_[ray.number];
  lines_.erase(ray.number);
  auto out = std::back_inserter(text_);
  fmt::format_to(out, "E\t{}\t0\t{}\n", line.id, name_of(line.stage).abbreviation);
  fmt::format_to(out, "R\t{}\t{}\t{}\n", line.id, retired_, cut ? 1 : 0);
  if (cut) return;
  ++retired_;
  parents_[ray.number] = line.id;
}

void KonataTrace::end(hw::Tick tick) {
  flush();
  covers(begin_, tick, unit_period_);
}

}  // namespace artu::sim
