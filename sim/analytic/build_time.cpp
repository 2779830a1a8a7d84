#include "sim/analytic/build_time.h"

#include <algorithm>

#include "sim/analytic/constants.h"
#include "sim/analytic/dram_service.h"

namespace artu::sim {
BuildTime build_time(const hw::UnitConfig& config, const hw::FrameDescriptor& frame, MemoryModel& memory) {
  BuildTime all;
  const double hit = 2.0 * config.memory.interconnect_latency + config.memory.l2.hit_latency + 2;
  for (const hw::BuildStep& step : hw::plan_build(config.tree_builder, frame)) {
    const MemoryCounts before = memory.counts();
    std::uint64_t lines = 0, longest = 0;
    for (const hw::BuildStream& stream : step.streams) {
      lines += stream.lines;
      longest = std::max(longest, stream.lines);
    }
    // The stream that is furthest behind goes first: all of them end at about the same time.
    std::vector<std::uint64_t> issued(step.streams.size(), 0);
    constexpr std::uint64_t run = 64;
    for (std::uint64_t at = 0; at < longest; at += run) {
      for (std::size_t i = 0; i < step.streams.size(); ++i) {
        const hw::BuildStream& stream = step.streams[i];
        const std::uint64_t until = std::min(stream.lines, (at + run) * stream.lines / longest);
        for (; issued[i] < until; ++issued[i]) {
          const std::uint64_t line = stream.base / 64 + issued[i];
          if (!is_sampled(line)) continue;
          if (stream.write) {
            memory.write(Client::builder, line, true, 0);
          } else {
            memory.read(Client::builder, 0, line, 0);
          }
        }
      }
    }
    MemoryCounts own = memory.counts();
    own -= before;
    const auto fills = static_cast<double>(own.l2_fills * sample_factor);
    const double dram = fills + static_cast<double>(own.l2_write_backs * sample_factor);
    const double bus = dram * bus_cycles(config) * calibrated.build_bus;
    // Each request holds one of the builder's places until it is answered.
    const double dram_latency = (config.memory.dram.t_rcd + config.memory.dram.t_cl) *
                                    static_cast<double>(config.clock_mhz) / config.memory.dram.clock_mhz +
                                16;
    const double places = (static_cast<double>(lines) * hit + fills * dram_latency) / config.tree_builder.outstanding;
    const double traffic = std::max({static_cast<double>(lines), bus, places});
    const auto cycles = static_cast<std::uint64_t>(std::max(static_cast<double>(step.compute), traffic) + hit);
    all.cycles += cycles;
    all.stages[static_cast<std::size_t>(step.stage)] += cycles;
    all.lines += lines;
    all.dram += static_cast<std::uint64_t>(dram);
  }
  return all;
}

}  // namespace artu::sim
