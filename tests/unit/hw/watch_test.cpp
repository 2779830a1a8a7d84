// What watches the unit: the same in every mode of simulation, complete, and of any window the same as of the whole.
#include <gmock/gmock.h>

#include <map>

#include "hw/watch/unit_watch.h"
#include "unit/hw/tiny_frame.h"

namespace artu::hw::test {
namespace {

/// Writes down all that it is told.
class Recorder : public ActivitySink {
 public:
  struct Entry {
    Tick tick;
    std::string what;  // of which thing
    std::string now;
    bool operator==(const Entry& other) const { return tick == other.tick && what == other.what && now == other.now; }
  };

  void begin(const ActivityLayout& layout, Tick tick) override {
    this->layout = layout;
    entries.clear();
    began = tick;
  }
  void phase(Tick tick, unsigned phase) override { add(tick, "phase", std::to_string(phase)); }
  void state(Tick tick, std::size_t block, State state) override {
    add(tick, layout.blocks[block].path, state_name(state));
  }
  void level(Tick tick, std::size_t channel, std::uint32_t entries) override {
    EXPECT_LE(entries, layout.channels[channel].capacity);
    add(tick, "channel " + layout.channels[channel].name, std::to_string(entries));
  }
  void ray_begins(Tick tick, const RayInFlight& ray) override {
    EXPECT_EQ(in_flight.count(ray.number), 0u);
    in_flight[ray.number] = ray.slot;
    EXPECT_EQ(ray.kind == RayKind::primary, ray.before == RayInFlight::none);
    add(tick, "ray " + std::to_string(ray.number), "begins");
  }
  void ray_enters(Tick tick, const RayInFlight& ray, RayStage stage) override {
    EXPECT_EQ(in_flight.count(ray.number), 1u);
    add(tick, "ray " + std::to_string(ray.number), name_of(stage).name);
  }
  void ray_ends(Tick tick, const RayInFlight& ray, bool cut) override {
    EXPECT_EQ(in_flight.erase(ray.number), 1u);
    add(tick, "ray " + std::to_string(ray.number), cut ? "cut" : "ends");
  }
  void end(Tick tick) override { ended = tick; }

  ActivityLayout layout;
  std::vector<Entry> entries;
  std::map<std::uint64_t, Slot> in_flight;
  Tick began = never, ended = 0;

 private:
  void add(Tick tick, const std::string& what, const std::string& now) {
    EXPECT_GE(tick, entries.empty() ? 0 : entries.back().tick);
    entries.push_back({tick, what, now});
  }
};

UnitConfig odd_clocks() {
  UnitConfig config = TinyUnit::small();
  config.clock_mhz = 533;
  return config;
}

struct Watched {
  explicit Watched(const RunMode& mode = {}, const ActivityWindow& window = {}, const UnitConfig& config = odd_clocks())
      : tiny(21, 13, mode, config) {
    tiny.unit.watch({&recorder}, window);
    result = tiny.run();
  }
  TinyUnit tiny;
  Recorder recorder;
  FrameResult result;
};

TEST(Watch, IsToldTheSameInEveryModeOfSimulation) {
  for (const bool stall : {false, true}) {
    RunMode mode;
    mode.random_stall = stall;
    const Watched event(mode);
    EXPECT_GT(event.recorder.entries.size(), 1000u);
    mode.clocked = true;
    EXPECT_TRUE(Watched(mode).recorder.entries == event.recorder.entries);
    mode.shuffle = true;
    EXPECT_TRUE(Watched(mode).recorder.entries == event.recorder.entries);
  }
}

TEST(Watch, StatesAddUpToTheCounters) {
  const Watched watched;
  const Recorder& seen = watched.recorder;
  EXPECT_EQ(seen.ended, watched.result.cycles * seen.layout.unit_period);
  for (const auto& block : seen.layout.blocks) {
    std::map<std::string, std::uint64_t> clocks;
    std::string state;
    Tick since = 0;
    const Tick end = seen.ended / block.period * block.period;
    const auto until = [&](Tick tick) {
      if (!state.empty()) clocks[state] += (tick - since) / block.period;
      since = tick;
    };
    for (const Recorder::Entry& entry : seen.entries) {
      if (entry.what != block.path) continue;
      until(std::min(entry.tick, end));
      EXPECT_NE(state, entry.now);
      state = entry.now;
    }
    until(end);
    for (std::size_t s = 0; s < state_count; ++s) {
      const std::string name = state_name(static_cast<State>(s));
      EXPECT_EQ(clocks[name], watched.tiny.statistic(watched.result, block.path, name)) << block.path << " " << name;
    }
  }
}

TEST(Watch, FollowsEveryRayToItsEnd) {
  const Watched watched;
  std::uint64_t begins = 0, ends = 0, rays = 0;
  std::map<std::string, std::string> last;
  for (const Recorder::Entry& entry : watched.recorder.entries) {
    begins += entry.now == "begins";
    ends += entry.now == "ends";
    if (entry.what.compare(0, 4, "ray ") != 0) continue;
    EXPECT_NE(last[entry.what], entry.now);
    if (entry.now == "ends") {
      EXPECT_THAT(last[entry.what], ::testing::AnyOf("shading", "queue for set-up")) << entry.what;
    }
    last[entry.what] = entry.now;
  }
  for (const Statistic& statistic : watched.result.statistics) {
    if (statistic.block.find("ray_generator") != std::string::npos && statistic.unit == "rays") rays += statistic.value;
  }
  EXPECT_GT(rays, 100u);
  EXPECT_EQ(begins, rays);
  EXPECT_EQ(ends, rays);
  EXPECT_TRUE(watched.recorder.in_flight.empty());
}

TEST(Watch, AWindowIsAPartOfTheWhole) {
  const Watched whole;
  const Tick period = whole.recorder.layout.unit_period;
  for (const auto& [from, to] : {std::pair<Cycle, Cycle>{0, 1}, {0, 100}, {301, 302}, {500, 1500}, {777, never}}) {
    RunMode clocked;
    clocked.clocked = true;
    for (const RunMode& mode : {RunMode{}, clocked}) {
      const Watched part(mode, {from, to});
      const Tick begin = from * period, end = to == never ? whole.recorder.ended : to * period;
      EXPECT_EQ(part.recorder.began, begin);
      EXPECT_EQ(part.recorder.ended, end);
      EXPECT_TRUE(part.recorder.in_flight.empty()) << "what is in flight at the end is cut";
      std::map<std::string, std::string> expected, told;
      std::vector<Recorder::Entry> later, later_told;
      for (const Recorder::Entry& entry : whole.recorder.entries) {
        if (entry.tick <= begin) {
          expected[entry.what] = entry.now;
          if (entry.now == "ends") expected.erase(entry.what);
        } else if (entry.tick < end || to == never) {
          later.push_back(entry);
        }
      }
      for (const Recorder::Entry& entry : part.recorder.entries) {
        if (entry.tick <= begin) {
          told[entry.what] = entry.now;
        } else if (entry.now != "cut") {
          later_told.push_back(entry);
        }
      }
      EXPECT_EQ(told, expected);
      EXPECT_TRUE(later_told == later) << from << ":" << to;
    }
  }
}

TEST(Watch, AWindowBehindTheFrameIsEmpty) {
  const Watched watched({}, {1000000, never});
  EXPECT_TRUE(watched.recorder.entries.empty());
  EXPECT_EQ(watched.recorder.began, watched.recorder.ended);
}

TEST(Watch, ChangesNothing) {
  TinyUnit alone(21, 13, {}, odd_clocks());
  const FrameResult expected = alone.run();
  Watched watched;
  EXPECT_EQ(watched.result.cycles, expected.cycles);
  EXPECT_EQ(watched.tiny.pixels(), alone.pixels());
  const std::size_t entries = watched.recorder.entries.size();
  EXPECT_EQ(watched.tiny.run().cycles, expected.cycles) << "a second frame begins anew";
  EXPECT_EQ(watched.recorder.entries.size(), entries);
}

}  // namespace
}  // namespace artu::hw::test
