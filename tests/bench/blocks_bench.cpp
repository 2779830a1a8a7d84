// What a cycle of the simulation costs: channels, the clock domain, caches, the DRAM.  Times are per token or tick.
#include <benchmark/benchmark.h>

#include "unit/hw/dram_support.h"

namespace artu::hw::test {
namespace {

constexpr std::uint32_t count = 4096;

void FifoPushPop(benchmark::State& state) {
  Bench bench;
  auto& fifo = bench.fifo<std::uint32_t>("fifo", 8);
  auto& source = bench.block<Source<std::uint32_t>>("source", fifo);
  auto& sink = bench.block<Sink<std::uint32_t>>("sink", fifo);
  fifo.bind(source, sink);
  for (std::uint32_t i = 0; i < count; ++i) source.push_at(1 + i, i);
  for (auto _ : state) bench.run(count + 8);
  state.SetItemsProcessed(state.iterations() * count);
}
BENCHMARK(FifoPushPop);

/// Has something to do in every cycle.
class Busy : public Block {
 public:
  using Block::Block;
  void reset() override {}

 private:
  Activity tick(Cycle now) override { return {State::busy, now + 1}; }
};

void ClockDomainTick(benchmark::State& state) {
  Bench bench;
  const auto blocks = static_cast<std::uint32_t>(state.range(0));
  for (std::uint32_t i = 0; i < blocks; ++i) bench.block<Busy>(("busy" + std::to_string(i)).c_str());
  for (auto _ : state) bench.run(count);
  state.SetItemsProcessed(state.iterations() * count * blocks);
}
BENCHMARK(ClockDomainTick)->Arg(1)->Arg(8)->Arg(64);

void CacheHit(benchmark::State& state) {
  CacheBench b(CacheConfig{16384, 4, 2, 8, 8});
  b.client().requests.push_at(1, read_of(0));
  for (std::uint32_t i = 0; i < count; ++i) b.client().requests.push_at(200 + i, read_of(0, i));
  for (auto _ : state) b.bench.run(count + 300);
  state.SetItemsProcessed(state.iterations() * count);
}
BENCHMARK(CacheHit);

void DramRequest(benchmark::State& state) {
  const bool rows_change = state.range(0) != 0;
  DramBench b{DramConfig()};
  for (std::uint32_t i = 0; i < count; ++i) b.read(2 + i, rows_change ? b.at(i % 8, i) : b.at(0, 0, i % 16), i);
  for (auto _ : state) b.run(count * 100);
  state.SetItemsProcessed(state.iterations() * count);
}
BENCHMARK(DramRequest)->Arg(0)->Arg(1)->ArgName("rows_change");

}  // namespace
}  // namespace artu::hw::test
