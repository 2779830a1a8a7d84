// How the unit is run, and falsified on purpose: no part of the chip.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace artu::hw {

/// How much of a block's doings is written to the log.
enum class LogLevel : std::uint8_t { off, info, debug };

/// Blocks whose path is `block`, or begins with it and a dot, or all for "*".
struct LogRule {
  std::string block;
  LogLevel level = LogLevel::off;
};

inline bool fits(const LogRule& rule, const std::string& path) {
  return rule.block == "*" || path == rule.block || path.compare(0, rule.block.size() + 1, rule.block + ".") == 0;
}

/// Where the lines of the log go, one at a time, without a line end.
using LogSink = std::function<void(const std::string&)>;

/// How the unit is run: no part of the chip.
struct RunMode {
  bool clocked = false;       // tick every block in every cycle
  bool shuffle = false;       // random order of blocks within a cycle
  bool random_stall = false;  // random latency on every channel
  std::uint64_t seed = 1;
  bool timeline = false;     // look at the unit from time to time: hw/fabric/sampler.h
  std::vector<LogRule> log;  // the last rule that fits a block counts
  LogSink log_sink;          // needed where there is a rule
};

/// Datapaths whose result can be falsified, to show that the golden comparison sees it; and the DRAM, an answer of
/// which can be lost, to show that the dead-lock is.
enum class Datapath : std::uint8_t { none, box, triangle, shading, interpolation, threshold, dram };

/// The bit of the datapath's result that is inverted in every operation; the number of the DRAM's answer that is lost.
struct Fault {
  Datapath datapath = Datapath::none;
  std::uint32_t bit = 0;
};

}  // namespace artu::hw
