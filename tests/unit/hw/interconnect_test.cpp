// The crossbar: fair, one request and one response a cycle, every response to its master.
#include "hw/memory/interconnect.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/hw/memory_support.h"

namespace artu::hw::test {
namespace {

constexpr std::uint32_t hop = 4;  // interconnect_latency
constexpr Cycle memory_latency = 10;

struct Crossbar {
  explicit Crossbar(std::size_t count) {
    below.bind(interconnect, memory);
    interconnect.add_memory(below);
    for (std::size_t i = 0; i < count; ++i) {
      masters.push_back(std::make_unique<Client>(bench, "master" + std::to_string(i), interconnect, 4, hop, hop));
      interconnect.add_master(masters.back()->link);
    }
    interconnect.flag_channels();
  }
  Client& master(std::size_t i) { return *masters[i]; }
  Bench bench;
  Interconnect& interconnect = bench.block<Interconnect>("interconnect");
  MemoryLink& below = bench.link("below", 4, 1, 1);
  ScriptedMemory& memory = bench.block<ScriptedMemory>("memory", below, 1, memory_latency);
  std::vector<std::unique_ptr<Client>> masters;
};

TEST(Interconnect, TakesItsLatencyEachWay) {
  Crossbar x(2);
  x.master(1).requests.push_at(10, read_of(640, 77));
  x.bench.run(100);
  EXPECT_EQ(x.memory.cycles, std::vector<Cycle>{10 + hop + 1});  // and the memory's own channel
  EXPECT_EQ(x.master(1).responses.cycles, std::vector<Cycle>{10 + hop + 1 + memory_latency + hop});
  EXPECT_EQ(x.master(1).tags(), std::vector<std::uint32_t>{77});
}

TEST(Interconnect, PassesOneRequestACycleForASingleMaster) {
  Crossbar x(3);
  for (std::uint32_t i = 0; i < 40; ++i) x.master(2).requests.push_at(1, read_of(64 * i, i));
  x.bench.run(200);
  EXPECT_EQ(x.memory.cycles, every(1 + hop + 1, 40));
  EXPECT_EQ(x.master(2).responses.cycles, every(1 + hop + 1 + memory_latency + hop, 40));
}

TEST(Interconnect, MastersTakeTurns) {
  Crossbar x(3);
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::size_t m = 0; m < 3; ++m) x.master(m).requests.push_at(1, read_of(1024 * (m + 1), i));
  }
  x.bench.run(200);
  std::vector<Address> expected;
  for (int i = 0; i < 12; ++i) expected.insert(expected.end(), {1024, 2048, 3072});
  EXPECT_EQ(x.memory.lines(), expected);
  EXPECT_EQ(x.memory.cycles, every(1 + hop + 1, 36));
}

TEST(Interconnect, EveryResponseGoesToTheMasterThatAsked) {
  Crossbar x(5);
  // Later requests are answered earlier, and all tags are the same: only the source tells them apart.
  x.memory.latency = [](const MemoryRequest& r) -> Cycle { return 200 - r.line / 64; };
  for (std::uint32_t i = 0; i < 20; ++i) {
    for (std::size_t m = 0; m < 5; ++m) x.master(m).requests.push_at(1, read_of(64 * (1 + 5 * i + m), 100 * m + i));
  }
  x.bench.run(600);
  for (std::uint32_t m = 0; m < 5; ++m) {
    auto tags = x.master(m).tags();
    std::sort(tags.begin(), tags.end());
    ASSERT_EQ(tags.size(), 20u);
    for (std::uint32_t i = 0; i < 20; ++i) EXPECT_EQ(tags[i], 100 * m + i);
  }
  EXPECT_EQ(counter(x.interconnect, "requests"), 100u);
  EXPECT_EQ(counter(x.interconnect, "responses"), 100u);
}

TEST(Interconnect, WaitsForTheMemoryBelow) {
  Crossbar x(2);
  x.memory.open = [](Cycle now) { return now >= 100; };
  for (std::uint32_t i = 0; i < 10; ++i) x.master(0).requests.push_at(1, read_of(64 * i + 64, i));
  x.bench.run(300);
  EXPECT_EQ(x.memory.cycles, every(100, 10));
  EXPECT_GT(x.interconnect.cycles_in(State::stall_out), 80u);
}

TEST(Interconnect, AMasterGetsOneResponseACycleFromAllMemories) {
  Bench bench;
  auto& interconnect = bench.block<Interconnect>("interconnect");
  MemoryLink &even = bench.link("even", 4, 1, 1), &odd = bench.link("odd", 4, 1, 1);
  auto& even_memory = bench.block<ScriptedMemory>("even_memory", even, 1, memory_latency);
  auto& odd_memory = bench.block<ScriptedMemory>("odd_memory", odd, 1, memory_latency);
  even.bind(interconnect, even_memory);
  odd.bind(interconnect, odd_memory);
  interconnect.add_memory(even);
  interconnect.add_memory(odd);
  Client master(bench, "master", interconnect, 4, hop, hop);
  interconnect.add_master(master.link);
  interconnect.flag_channels();
  // The second line is asked for a cycle later, and its memory is that cycle faster.
  odd_memory.latency = [](const MemoryRequest&) -> Cycle { return memory_latency - 1; };
  master.requests.push_at(1, read_of(128, 7)).push_at(2, read_of(64, 8));
  bench.run(100);
  const Cycle first = 1 + hop + 1 + memory_latency + hop;
  EXPECT_EQ(master.responses.cycles, (std::vector<Cycle>{first, first + 1}));
  EXPECT_EQ(counter(interconnect, "conflicts"), 1u);
  EXPECT_EQ(counter(interconnect, "responses"), 2u);
}

}  // namespace
}  // namespace artu::hw::test
