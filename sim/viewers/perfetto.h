// A trace for ui.perfetto.dev, in Perfetto's own format (docs/viewers.md): a track a block with its states in the
// phases of the frame, a counter a channel, a flow a ray.  A cycle of the unit is a microsecond. Source:
// protos/perfetto/trace/{trace_packet,track_event/*,interned_data/*}.proto of the Perfetto project.
#pragma once

#include <array>
#include <vector>

#include "sim/viewers/trace_writer.h"
#include "sim/viewers/wire.h"

namespace artu::sim {

class PerfettoTrace : public TraceWriter {
 public:
  /// `title` names the whole in the viewer.
  PerfettoTrace(const std::string& name, bool force, std::string title)
      : TraceWriter(name, force), title_(std::move(title)) {}

  void begin(const hw::ActivityLayout& layout, hw::Tick tick) override;
  void phase(hw::Tick tick, unsigned phase) override;
  void state(hw::Tick tick, std::size_t block, hw::State state) override;
  void level(hw::Tick tick, std::size_t channel, std::uint32_t entries) override;
  void ray_begins(hw::Tick tick, const hw::RayInFlight& ray) override;
  void ray_enters(hw::Tick tick, const hw::RayInFlight& ray, hw::RayStage stage) override;
  void ray_ends(hw::Tick tick, const hw::RayInFlight& ray, bool cut) override;
  void end(hw::Tick tick) override;

 private:
  static constexpr std::size_t stations = 5;  // blocks of a core that a ray goes through
  void describe_tracks();
  void intern_names();
  std::uint64_t group(const std::string& name);
  void track(std::uint64_t uuid, std::uint64_t parent, const std::string& name, const WireMessage* counter = nullptr);
  void event(hw::Tick tick, std::uint64_t track, unsigned type, std::uint64_t name = 0);
  void put(hw::Tick tick);
  void put(const WireMessage& packet);
  void begin_states();
  void end_slices(hw::Tick tick);
  void visit(hw::Tick tick, const hw::RayInFlight& ray, std::size_t station);

  const std::string title_;
  hw::ActivityLayout layout_;
  hw::Tick begin_ = 0;
  std::uint64_t first_block_ = 0, first_channel_ = 0;  // their tracks
  std::vector<std::string> groups_;
  std::vector<std::array<std::uint64_t, stations>> station_tracks_;  // by core
  std::vector<hw::State> states_;                                    // by block
  std::vector<bool> in_state_;                                       // a slice of it is open
  unsigned phase_ = 0;                                               // 0: none yet
  hw::Tick phase_tick_ = 0;
  bool waiting_ = false;  // slices of the new phase are not all begun: what changes at the same tick comes first
  struct Lane {
    std::uint64_t ray = hw::RayInFlight::none;  // whose flow has begun
    std::size_t station = 0;
  };
  std::vector<std::vector<Lane>> lanes_;  // by core and context
  WireMessage packet_, event_;
  std::string framed_;
};

}  // namespace artu::sim
