#include "sim/report/timeline_json.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "hw/fabric/phase.h"
#include "sim/report/cycle_table.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

/// Blocks or channels of one kind, in the order in which they first come: [name, members].
using Kinds = std::vector<std::pair<std::string, std::vector<std::size_t>>>;

Kinds kinds_of(const std::vector<std::string>& names) {
  Kinds kinds;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string kind = without_number(names[i]);
    const auto [place, is_new] = places.emplace(kind, kinds.size());
    if (is_new) kinds.push_back({kind, {}});
    kinds[place->second].second.push_back(i);
  }
  return kinds;
}

/// Cycles of the members in this state so far, or between two looks.
std::uint64_t cycles(const hw::Snapshot& now, const hw::Snapshot* before, const std::vector<std::size_t>& members,
                     std::size_t state) {
  std::uint64_t sum = 0;
  for (const std::size_t member : members) {
    const std::size_t i = member * hw::state_count + state;
    sum += now.states[i] - (before ? before->states[i] : 0);
  }
  return sum;
}

Json blocks_of(const hw::FrameTimeline& timeline) {
  Json blocks = Json::object();
  for (const auto& [kind, members] : kinds_of(timeline.blocks)) {
    Json& block = blocks[kind] = {{"count", members.size()}};
    for (std::size_t state = 0; state < hw::state_count; ++state) {
      Json& values = block[hw::state_name(static_cast<hw::State>(state))] = Json::array();
      const hw::Snapshot* before = nullptr;
      for (const hw::Snapshot& sample : timeline.samples) {
        values.push_back(cycles(sample, before, members, state));
        before = &sample;
      }
    }
  }
  return blocks;
}

Json channels_of(const hw::FrameTimeline& timeline) {
  Json channels = Json::object();
  for (const auto& [kind, members] : kinds_of(timeline.channels)) {
    std::uint64_t capacity = 0;
    for (const std::size_t member : members) capacity += timeline.capacities[member];
    Json levels = Json::array();
    for (const hw::Snapshot& sample : timeline.samples) {
      std::uint64_t level = 0;
      for (const std::size_t member : members) level += sample.levels[member];
      levels.push_back(level);
    }
    channels[kind] = {{"count", members.size()}, {"capacity", capacity}, {"level", levels}};
  }
  return channels;
}

/// What was counted since the look before.
Json counts_of(const hw::FrameTimeline& timeline) {
  Json counts = Json::object();
  for (std::size_t i = 0; i < timeline.counts.size(); ++i) {
    Json& values = counts[timeline.counts[i]] = Json::array();
    std::uint64_t before = 0;
    for (const hw::Snapshot& sample : timeline.samples) {
      values.push_back(sample.counts[i] - before);
      before = sample.counts[i];
    }
  }
  return counts;
}

/// From where a phase begins to where the next one does: five states of each kind of block.  A phase that goes on is
/// entered twice.
Json phases_of(const hw::FrameTimeline& timeline) {
  Json phases = Json::array();
  const Kinds kinds = kinds_of(timeline.blocks);
  hw::Snapshot begin;
  begin.states.resize(timeline.blocks.size() * hw::state_count);
  unsigned phase = hw::phase_start;
  const auto end = [&](const hw::Snapshot& at) {
    if (at.at == begin.at) return;
    Json blocks = Json::object();
    for (const auto& [kind, members] : kinds) {
      for (std::size_t state = 0; state < hw::state_count; ++state) {
        blocks[kind][hw::state_name(static_cast<hw::State>(state))] = cycles(at, &begin, members, state);
      }
    }
    phases.push_back({{"phase", hw::phase_name(phase)}, {"from", begin.at}, {"to", at.at}, {"blocks", blocks}});
  };
  for (const hw::FrameTimeline::Phase& next : timeline.phases) {
    end(next.at);
    begin = next.at;
    phase = next.phase;
  }
  end(timeline.samples.back());
  return phases;
}

}  // namespace

std::string timeline_of(const FrameOutcome& outcome) {
  const hw::FrameTimeline& timeline = outcome.timeline;
  Json at = Json::array();
  for (const hw::Snapshot& sample : timeline.samples) at.push_back(sample.at);
  Json visits = Json::object();
  static const char* const kinds[hw::ray_kinds] = {"primary", "shadow", "reflection", "refraction"};
  for (std::size_t kind = 0; kind < hw::ray_kinds; ++kind) visits[kinds[kind]] = outcome.visits[kind];
  const Json frame = {{"index", outcome.index},
                      {"cycles", outcome.cycles},
                      {"interval", timeline.interval},
                      {"at", at},
                      {"phases", phases_of(timeline)},
                      {"blocks", blocks_of(timeline)},
                      {"channels", channels_of(timeline)},
                      {"counts", counts_of(timeline)},
                      {"visits", visits}};
  return frame.dump();
}

TimelineJson::TimelineJson(const std::string& file) : file_(file) {
  file_.write(fmt::format("{{\"schema\": {}, \"frames\": [", schema));
}

void TimelineJson::add(const std::string& frame) {
  file_.write(first_ ? "\n" : ",\n");
  file_.write(frame);
  first_ = false;
}

void TimelineJson::finish() {
  file_.write("\n]}\n");
  file_.close();
}

}  // namespace artu::sim
