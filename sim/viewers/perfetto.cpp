#include "sim/viewers/perfetto.h"

#include <algorithm>

#include "hw/fabric/phase.h"

namespace artu::sim {

namespace {

constexpr std::uint64_t cycle_ns = 1000;
constexpr std::uint64_t root_track = 1, phase_track = 2, first_group = 3;
constexpr std::uint64_t no_station = 5;

/// Numbers of fields, named after message and field.
enum : std::uint32_t {
  trace_packet = 1,
  packet_timestamp = 8,
  packet_sequence = 10,
  packet_track_event = 11,
  packet_interned_data = 12,
  packet_sequence_flags = 13,
  packet_track_descriptor = 60,
  interned_event_names = 2,
  interned_annotation_names = 3,
  interned_id = 1,
  interned_name = 2,
  descriptor_uuid = 1,
  descriptor_name = 2,
  descriptor_process = 3,
  descriptor_parent = 5,
  descriptor_counter = 8,
  descriptor_child_ordering = 11,
  descriptor_rank = 12,
  process_pid = 1,
  process_name = 6,
  counter_unit_name = 6,
  event_annotations = 4,
  event_type = 9,
  event_name_id = 10,
  event_track = 11,
  event_counter_value = 30,
  event_flows = 47,
  event_terminating_flows = 48,
  annotation_name_id = 1,
  annotation_uint = 3
};
enum : unsigned { slice_begin = 1, slice_end = 2, instant = 3, counter = 4 };
enum : unsigned { state_cleared = 1, needs_state = 2, explicit_ordering = 3 };

// Interned names: 1 to 5 the states, then the phases, the kinds of rays, and how they end.
constexpr std::uint64_t first_phase_name = 6, first_ray_name = 11, ray_end_name = 15, ray_cut_name = 16;

std::uint64_t name_of_state(hw::State state) { return static_cast<std::uint64_t>(state) + 1; }
std::uint64_t name_of_phase(unsigned phase) {
  return first_phase_name + static_cast<std::uint64_t>(__builtin_ctz(phase));
}

const char* const station_names[] = {"ray_generator", "traversal", "intersection", "hit_point", "shading"};

/// The block that works on the ray; none while it is in a queue.
std::size_t station_of(hw::RayStage stage) {
  switch (stage) {
    case hw::RayStage::set_up:
      return 0;
    case hw::RayStage::traversal:
    case hw::RayStage::node_fetch:
      return 1;
    case hw::RayStage::intersection:
    case hw::RayStage::triangle_fetch:
      return 2;
    case hw::RayStage::hit_point:
    case hw::RayStage::surface_fetch:
      return 3;
    case hw::RayStage::shading:
    case hw::RayStage::texture_fetch:
      return 4;
    default:
      return no_station;
  }
}

/// "core0" of "core0.traversal", or "unit".
std::string owner_of(const std::string& path) {
  return path.compare(0, 4, "core") == 0 ? path.substr(0, path.find('.')) : "unit";
}

std::string name_in_owner(const std::string& path) {
  return path.compare(0, 4, "core") == 0 ? path.substr(path.find('.') + 1) : path;
}

}  // namespace

void PerfettoTrace::put(const WireMessage& packet) {
  WireMessage framed;
  framed.message(trace_packet, packet);
  write(framed.bytes());
}

/// What is in event_, as a packet.
void PerfettoTrace::put(hw::Tick tick) {
  packet_.clear();
  packet_.varint(packet_timestamp, tick * cycle_ns / layout_.unit_period);
  packet_.varint(packet_sequence, 1);
  packet_.varint(packet_sequence_flags, needs_state);
  packet_.message(packet_track_event, event_);
  put(packet_);
}

void PerfettoTrace::event(hw::Tick tick, std::uint64_t track, unsigned type, std::uint64_t name) {
  event_.clear();
  event_.varint(event_type, type);
  event_.varint(event_track, track);
  if (name != 0) event_.varint(event_name_id, name);
  put(tick);
}

void PerfettoTrace::track(std::uint64_t uuid, std::uint64_t parent, const std::string& name,
                          const WireMessage* counter) {
  WireMessage descriptor;
  descriptor.varint(descriptor_uuid, uuid);
  descriptor.text(descriptor_name, name);
  if (parent != 0) {
    descriptor.varint(descriptor_parent, parent);
    descriptor.varint(descriptor_rank, uuid);
  } else {
    WireMessage process;
    process.varint(process_pid, 1);
    process.text(process_name, name);
    descriptor.message(descriptor_process, process);
  }
  if (counter != nullptr) {
    descriptor.message(descriptor_counter, *counter);
  } else {
    descriptor.varint(descriptor_child_ordering, explicit_ordering);
  }
  packet_.clear();
  packet_.varint(packet_sequence, 1);
  packet_.message(packet_track_descriptor, descriptor);
  put(packet_);
}

void PerfettoTrace::intern_names() {
  WireMessage interned;
  const auto add = [&interned](std::uint32_t field, std::uint64_t id, std::string_view name) {
    WireMessage entry;
    entry.varint(interned_id, id);
    entry.text(interned_name, name);
    interned.message(field, entry);
  };
  for (std::size_t s = 0; s < hw::state_count; ++s) {
    const auto state = static_cast<hw::State>(s);
    add(interned_event_names, name_of_state(state), hw::state_name(state));
  }
  for (const unsigned phase :
       {hw::phase_start, hw::phase_build, hw::phase_first, hw::phase_selective, hw::phase_flush}) {
    add(interned_event_names, name_of_phase(phase), hw::phase_name(phase));
  }
  std::uint64_t id = first_ray_name;
  for (const char* name : {"primary ray", "shadow ray", "reflection ray", "refraction ray", "end of ray", "cut"}) {
    add(interned_event_names, id++, name);
  }
  id = 1;
  for (const char* name : {"ray", "x", "y"}) add(interned_annotation_names, id++, name);
  packet_.clear();
  packet_.varint(packet_sequence, 1);
  packet_.varint(packet_sequence_flags, state_cleared);
  packet_.message(packet_interned_data, interned);
  put(packet_);
}

/// The track of a group, which is described when it is first asked for.
std::uint64_t PerfettoTrace::group(const std::string& name) {
  const auto known = std::find(groups_.begin(), groups_.end(), name);
  const std::uint64_t uuid = first_group + static_cast<std::uint64_t>(known - groups_.begin());
  if (known == groups_.end()) {
    groups_.push_back(name);
    track(uuid, root_track, name);
  }
  return uuid;
}

void PerfettoTrace::describe_tracks() {
  groups_.clear();
  track(root_track, 0, title_);
  track(phase_track, root_track, "phase");
  // No more groups than these, whose tracks are numbered first.
  first_block_ = first_group + 2 * (std::uint64_t{layout_.cores} + 1);
  first_channel_ = first_block_ + layout_.blocks.size();
  station_tracks_.assign(layout_.cores, {});
  for (std::size_t i = 0; i < layout_.blocks.size(); ++i) {
    const std::string& path = layout_.blocks[i].path;
    track(first_block_ + i, group(owner_of(path)), name_in_owner(path));
    for (std::size_t core = 0; core < layout_.cores; ++core) {
      for (std::size_t station = 0; station < stations; ++station) {
        if (path == "core" + std::to_string(core) + "." + station_names[station]) {
          station_tracks_[core][station] = first_block_ + i;
        }
      }
    }
  }
  for (std::size_t i = 0; i < layout_.channels.size(); ++i) {
    const auto& channel = layout_.channels[i];
    WireMessage counter;
    counter.text(counter_unit_name, "of " + std::to_string(channel.capacity));
    track(first_channel_ + i, group("queues of " + owner_of(channel.name)), name_in_owner(channel.name), &counter);
  }
}

void PerfettoTrace::begin(const hw::ActivityLayout& layout, hw::Tick tick) {
  layout_ = layout;
  begin_ = phase_tick_ = tick;
  phase_ = 0;
  waiting_ = false;
  states_.assign(layout.blocks.size(), hw::State::idle);
  in_state_.assign(layout.blocks.size(), false);
  lanes_.assign(layout.cores, {});
  intern_names();
  describe_tracks();
}

void PerfettoTrace::begin_states() {
  if (!waiting_) return;
  waiting_ = false;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (in_state_[i]) continue;
    in_state_[i] = true;
    event(phase_tick_, first_block_ + i, slice_begin, name_of_state(states_[i]));
  }
}

void PerfettoTrace::end_slices(hw::Tick tick) {
  begin_states();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (in_state_[i]) event(tick, first_block_ + i, slice_end);
    if (phase_ != 0) event(tick, first_block_ + i, slice_end);
    in_state_[i] = false;
  }
  if (phase_ != 0) event(tick, phase_track, slice_end);
}

void PerfettoTrace::phase(hw::Tick tick, unsigned phase) {
  end_slices(tick);
  phase_ = phase;
  phase_tick_ = tick;
  event(tick, phase_track, slice_begin, name_of_phase(phase));
  for (std::size_t i = 0; i < states_.size(); ++i) event(tick, first_block_ + i, slice_begin, name_of_phase(phase));
  waiting_ = true;
}

void PerfettoTrace::state(hw::Tick tick, std::size_t block, hw::State state) {
  if (tick > phase_tick_) begin_states();
  states_[block] = state;
  if (in_state_[block]) event(tick, first_block_ + block, slice_end);
  in_state_[block] = true;
  event(tick, first_block_ + block, slice_begin, name_of_state(state));
}

void PerfettoTrace::level(hw::Tick tick, std::size_t channel, std::uint32_t entries) {
  begin_states();
  event_.clear();
  event_.varint(event_type, counter);
  event_.varint(event_track, first_channel_ + channel);
  event_.varint(event_counter_value, entries);
  put(tick);
}

void PerfettoTrace::ray_begins(hw::Tick, const hw::RayInFlight& ray) {
  begin_states();
  std::vector<Lane>& lanes = lanes_[ray.core];
  if (lanes.size() <= ray.slot) lanes.resize(ray.slot + std::size_t{1});
  lanes[ray.slot] = {};
}

/// The ray comes to a block.
void PerfettoTrace::visit(hw::Tick tick, const hw::RayInFlight& ray, std::size_t station) {
  Lane& lane = lanes_[ray.core][ray.slot];
  const bool first = lane.ray != ray.number;
  if (!first && lane.station == station) return;
  lane = {ray.number, station};
  event_.clear();
  event_.varint(event_type, instant);
  event_.varint(event_track, station_tracks_[ray.core][station]);
  event_.varint(event_name_id, first_ray_name + static_cast<std::uint64_t>(ray.kind));
  if (first) {
    std::uint64_t id = 1;
    for (const std::uint64_t value : {ray.number, std::uint64_t{ray.x}, std::uint64_t{ray.y}}) {
      WireMessage annotation;
      annotation.varint(annotation_name_id, id++);
      annotation.varint(annotation_uint, value);
      event_.message(event_annotations, annotation);
    }
  }
  event_.fixed64(event_flows, ray.number + 1);
  put(tick);
}

void PerfettoTrace::ray_enters(hw::Tick tick, const hw::RayInFlight& ray, hw::RayStage stage) {
  begin_states();
  if (const std::size_t station = station_of(stage); station != no_station) visit(tick, ray, station);
}

void PerfettoTrace::ray_ends(hw::Tick tick, const hw::RayInFlight& ray, bool cut) {
  begin_states();
  const Lane& lane = lanes_[ray.core][ray.slot];
  if (lane.ray != ray.number) return;  // it was in a queue all the time
  event_.clear();
  event_.varint(event_type, instant);
  event_.varint(event_track, station_tracks_[ray.core][lane.station]);
  event_.varint(event_name_id, cut ? ray_cut_name : ray_end_name);
  event_.fixed64(event_terminating_flows, ray.number + 1);
  put(tick);
}

void PerfettoTrace::end(hw::Tick tick) {
  end_slices(tick);
  covers(begin_, tick, layout_.unit_period);
}

}  // namespace artu::sim
