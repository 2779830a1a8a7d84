// Miss-ratio curves from one run, against the caches of the event model, which are simulated size by size.
#include <gmock/gmock.h>

#include "golden/harness.h"
#include "sim/reuse/reuse_report.h"

namespace artu::golden_tests {
namespace {

using hw::line_bytes;

const TestScene& scene() {
  static const TestScene scene = [] {
    Recipe recipe;
    recipe.mirror = recipe.glass = true;
    recipe.frames = 2;
    return make_scene(recipe);
  }();
  return scene;
}

struct Profiled {
  std::vector<sim::CacheReuse> kinds;
  std::vector<sim::ModelMisses> model;

  const sim::CacheReuse& kind(const std::string& name) const { return kinds.at(index(name)); }
  const sim::ModelMisses& of_model(const std::string& name) const { return model.at(index(name)); }
  std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      if (kinds[i].name == name) return i;
    }
    throw std::out_of_range(name);
  }
};

/// All frames of the scene.
Profiled profile(const hw::UnitConfig& unit, bool random_stall = false) {
  Profiled out;
  sim::ReuseProfile profile(unit, 1000);
  sim::SimulationOptions options;
  options.request_sink = &profile;
  options.random_stall = random_stall;
  sim::Simulator simulator(scene().scene, unit, options, frames_of(scene()));
  for (const traces::Frame& frame : scene().frames) {
    const sim::FrameOutcome outcome = simulator.run(frame);
    EXPECT_TRUE(outcome.violations.empty());
    const std::vector<sim::CacheReuse> kinds = profile.end_frame(frame.index, outcome.cycles);
    const std::vector<sim::ModelMisses> model = sim::misses_of_model(kinds, outcome.statistics);
    sim::add(out.kinds, kinds);
    out.model.resize(model.size());
    for (std::size_t i = 0; i < model.size(); ++i) {
      out.model[i].requests += model[i].requests;
      out.model[i].misses += model[i].misses;
    }
  }
  return out;
}

/// One ray at a time: its nodes arrive in the order in which they are asked for, whatever the cache's size.
hw::UnitConfig one_ray() {
  hw::UnitConfig unit;
  unit.core.count = unit.core.contexts = 1;
  return unit;
}

void set_size(hw::CacheConfig& cache, std::uint32_t lines) {
  cache.size = lines * line_bytes;
  cache.ways = lines;
}

void set_l1_sizes(hw::UnitConfig& unit, std::uint32_t lines) {
  set_size(unit.core.node_cache, lines);
  set_size(unit.core.triangle_cache, lines);
  set_size(unit.core.texture_cache, lines);
}

TEST(Reuse, OneRunTellsTheMissesOfNodeCachesOfEverySize) {
  const Profiled once = profile(one_ray());
  for (const std::uint32_t lines : {1u, 2u, 4u, 8u, 16u, 64u}) {
    hw::UnitConfig unit = one_ray();
    set_l1_sizes(unit, lines);
    const Profiled there = profile(unit);
    EXPECT_EQ(there.of_model("node_cache").requests, once.kind("node_cache").requests);
    EXPECT_EQ(there.of_model("node_cache").misses, once.kind("node_cache").misses(lines)) << lines << " lines";
    for (const char* name : {"node_cache", "triangle_cache", "texture_cache"}) {
      EXPECT_EQ(there.kind(name).lines, lines);
      EXPECT_EQ(there.kind(name).distances, once.kind(name).distances) << name;
    }
  }
}

/// Where several lines are on their way a cache still has what it would have replaced, and misses a little less.
TEST(Reuse, OneRunTellsNearlyTheMissesWhereManyRaysAskAtATime) {
  for (const std::uint32_t lines : {32u, 64u, 128u}) {
    hw::UnitConfig unit;
    set_l1_sizes(unit, lines);
    const Profiled run = profile(unit);
    for (const char* name : {"node_cache", "triangle_cache", "texture_cache"}) {
      const auto foretold = static_cast<double>(run.kind(name).misses(lines));
      EXPECT_NEAR(static_cast<double>(run.of_model(name).misses), foretold, 0.05 * foretold) << name << ", " << lines;
    }
  }
}

/// What a cache is asked for, and, as a line of its own, when it forgets.
struct Recorder : hw::RequestSink {
  struct Asked {
    hw::Address line;
    enum { use, forget, forget_all } what;
  };
  void begin_frame(const std::vector<std::string>& caches) override {
    paths = caches;
    asked.assign(caches.size(), {});
  }
  void request(std::size_t cache, hw::Cycle, const hw::MemoryRequest& r) override {
    asked[cache].push_back({r.line, Asked::use});
  }
  void forget(std::size_t cache, hw::Address line) override { asked[cache].push_back({line, Asked::forget}); }
  void forget_all(std::size_t cache) override { asked[cache].push_back({0, Asked::forget_all}); }

  std::vector<std::string> paths;
  std::vector<std::vector<Asked>> asked;
};

/// Of a cache of so many lines, simulated request by request.
std::uint64_t misses_of_lru(const std::vector<Recorder::Asked>& asked, std::size_t lines) {
  std::vector<hw::Address> held;  // the last one was used last
  std::uint64_t misses = 0;
  for (const Recorder::Asked& a : asked) {
    if (a.what == Recorder::Asked::forget_all) {
      held.clear();
      continue;
    }
    const auto found = std::find(held.begin(), held.end(), a.line);
    const bool there = found != held.end();
    if (there) held.erase(found);
    if (a.what == Recorder::Asked::forget) continue;
    misses += there ? 0 : 1;
    if (held.size() == lines) held.erase(held.begin());
    held.push_back(a.line);
  }
  return misses;
}

TEST(Reuse, CurvesAreThoseOfCachesSimulatedRequestByRequest) {
  hw::UnitConfig unit;
  unit.selective.overlap = true;  // for lines that are forgotten one by one
  unit.core.count = 2;
  Recorder recorder;
  sim::SimulationOptions options;
  options.request_sink = &recorder;
  const traces::Frame& frame = scene().frames.at(1);
  sim::Simulator(scene().scene, unit, options, frames_of(scene())).run(frame);
  const auto seen = [&recorder](auto what) {
    return std::any_of(recorder.asked.begin(), recorder.asked.end(), [what](const auto& asked) {
      return std::any_of(asked.begin(), asked.end(), [what](const auto& a) { return a.what == what; });
    });
  };
  EXPECT_TRUE(seen(Recorder::Asked::forget));
  EXPECT_TRUE(seen(Recorder::Asked::forget_all));
  sim::ReuseProfile profile(unit, 1000);
  options.request_sink = &profile;
  const sim::FrameOutcome outcome = sim::Simulator(scene().scene, unit, options, frames_of(scene())).run(frame);
  for (const sim::CacheReuse& kind : profile.end_frame(frame.index, outcome.cycles)) {
    if (kind.name == "l2") continue;  // its banks' requests are one stream, in the order of their cycles
    for (const std::uint64_t lines : {1u, 2u, 3u, 5u, 8u, 13u, 64u, 200u}) {
      std::uint64_t misses = 0;
      for (std::size_t i = 0; i < recorder.paths.size(); ++i) {
        if (sim::kind_of_cache(recorder.paths[i]) == kind.name) misses += misses_of_lru(recorder.asked[i], lines);
      }
      EXPECT_EQ(kind.misses(lines), misses) << kind.name << " of " << lines << " lines";
    }
  }
}

TEST(Reuse, SeesEveryRequestThatTheCachesServe) {
  for (const std::uint32_t banks : {1u, 4u}) {
    hw::UnitConfig unit;
    unit.memory.l2_banks = banks;
    for (const bool random_stall : {false, true}) {
      const Profiled run = profile(unit, random_stall);
      EXPECT_EQ(run.kinds.size(), 5u);
      for (std::size_t i = 0; i < run.kinds.size(); ++i) {
        EXPECT_GT(run.kinds[i].requests, 0u) << run.kinds[i].name;
        EXPECT_EQ(run.kinds[i].requests, run.model[i].requests) << run.kinds[i].name;
      }
      EXPECT_EQ(run.kind("l2").caches, 1u);
      EXPECT_EQ(run.kind("node_cache").caches, unit.core.count);
    }
  }
}

/// What the extractor has seen is old in the next pass, with overlap line by line: no size helps.
TEST(Reuse, ForgottenLinesAreFirstUsesAgain) {
  for (const bool overlap : {false, true}) {
    hw::UnitConfig unit;
    unit.selective.overlap = overlap;
    set_size(unit.selective.pixel_cache, 256);
    const Profiled run = profile(unit);
    const sim::CacheReuse& pixels = run.kind("pixel_cache");
    EXPECT_EQ(run.of_model("pixel_cache").misses, pixels.misses(256)) << "overlap " << overlap;
    EXPECT_EQ(pixels.misses(256), pixels.first_uses);
  }
}

TEST(Reuse, CurvesFallAndEndAtTheFirstUses) {
  for (const sim::CacheReuse& kind : profile({}).kinds) {
    std::uint64_t before = kind.requests;
    const std::vector<std::uint64_t> sizes = sim::sizes_of_curve(kind);
    for (const std::uint64_t size : sizes) {
      EXPECT_LE(kind.misses(size), before) << kind.name << ", " << size;
      before = kind.misses(size);
    }
    EXPECT_EQ(kind.misses(sizes.back()), kind.first_uses) << kind.name;
    EXPECT_EQ(kind.misses(kind.enough()), kind.first_uses) << kind.name;
    EXPECT_EQ(kind.misses(0), kind.requests) << kind.name;
  }
}

/// Windows hold every request, and at most as many lines as requests.
TEST(Reuse, WorkingSetsCoverTheFrame) {
  for (const sim::CacheReuse& kind : profile({}).kinds) {
    std::uint64_t requests = 0;
    for (const sim::WorkingSet& set : kind.windows) {
      requests += set.requests;
      EXPECT_LE(set.largest, set.requests);
      EXPECT_LE(set.lines, static_cast<double>(set.largest));
      EXPECT_EQ(set.largest == 0, set.requests == 0);
      EXPECT_EQ(set.cycle % 1000, 0u);
    }
    EXPECT_EQ(requests, kind.requests) << kind.name;
  }
}

TEST(Reuse, TwoObserversAreRefused) {
  sim::ReuseProfile profile({}, 1000);
  sim::SimulationOptions options;
  options.request_sink = &profile;
  struct : hw::ActivitySink {
    void begin(const hw::ActivityLayout&, hw::Tick) override {}
    void phase(hw::Tick, unsigned) override {}
    void state(hw::Tick, std::size_t, hw::State) override {}
    void level(hw::Tick, std::size_t, std::uint32_t) override {}
    void ray_begins(hw::Tick, const hw::RayInFlight&) override {}
    void ray_enters(hw::Tick, const hw::RayInFlight&, hw::RayStage) override {}
    void ray_ends(hw::Tick, const hw::RayInFlight&, bool) override {}
    void end(hw::Tick) override {}
  } viewer;
  options.watchers = {&viewer};
  EXPECT_THROW(sim::Simulator(scene().scene, {}, options), std::logic_error);
}

}  // namespace
}  // namespace artu::golden_tests
