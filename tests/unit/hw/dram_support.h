// A DRAM with one scripted client, in one clock domain.
#pragma once

#include "hw/memory/dram.h"
#include "unit/hw/memory_support.h"

namespace artu::hw::test {

/// The bench's clock is the DRAM's; answers take one clock of channel.
struct DramBench {
  explicit DramBench(const DramConfig& config)
      : config(config), dram(bench.block<Dram>("dram", config)), client(bench, "client", dram, 64, 1, 1) {
    dram.bind(client.link);
  }
  /// A line of the default mapping, where the banks are not hashed.
  Address at(std::uint64_t bank, std::uint64_t row, std::uint64_t column = 0, std::uint64_t channel = 0) const {
    return (((row * config.banks + bank) * (config.row_bytes / 64) + column) * config.channels + channel) * 64;
  }
  /// Requests that arrive in this cycle or later, in the order of the calls.
  DramBench& read(Cycle cycle, Address line, std::uint32_t tag = 0) {
    client.requests.push_at(cycle - 1, read_of(line, tag));
    return *this;
  }
  DramBench& write(Cycle cycle, Address line, std::uint32_t tag = 0) {
    client.requests.push_at(cycle - 1, write_of(line, whole_line, tag));
    return *this;
  }
  /// The cycles of the answers.
  std::vector<Cycle> run(Cycle cycles = 100000) {
    bench.run(cycles);
    return client.responses.cycles;
  }
  std::uint64_t count(const char* name) { return counter(dram, name); }

  const DramConfig config;
  Bench bench;
  Dram& dram;
  Client client;
};

}  // namespace artu::hw::test
