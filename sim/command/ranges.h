// Options that are more than a word: `--frames`, `--size`, `--seed`, `--inject-fault`, `--log`, `--bits`, `--trees`,
// `--memory-trace-format`, `--trace`, `--pictures`, `--references`, `--shares`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hw/run_mode.h"
#include "hw/unit_config.h"
#include "sim/report/memory_trace.h"
#include "sim/report/picture_set.h"
#include "sim/viewers/trace_set.h"

namespace artu::sim {

/// Half-open.
struct FrameRange {
  std::uint32_t first = 0, last = 1;
  std::uint32_t count() const { return last - first; }
};

/// "A:B" or "A"; nothing for "all".  Throws InputError.
std::optional<FrameRange> parse_frames(const std::string& text);

struct PictureSize {
  std::uint32_t width = 640, height = 360;
};

/// "WxH", each 1 ... 16384.  Throws InputError.
PictureSize parse_size(const std::string& text);

/// Above 0, up to 1000000.  Throws InputError.
void check_fps(double fps);

/// "DATAPATH" or "DATAPATH:BIT", as in `--inject-fault box:31`; without BIT the lowest.  Throws InputError.
hw::Fault parse_fault(const std::string& text);

/// "BLOCK=LEVEL", as in `--log core0.traversal=debug`.  Throws InputError; whether there is such a block shows later.
hw::LogRule parse_log_rule(const std::string& text);

/// Items between commas: M (of all three datapaths), M-N (all widths from M to N), BOX/TRIANGLE (shading 23), or
/// BOX/TRIANGLE/SHADING, each 7 ... 23.  Throws InputError.
std::vector<hw::PrecisionConfig> parse_formats(const std::string& text);

/// Names of trees between commas: bvh2, bvh4, bvh8, kd.  Throws InputError.
std::vector<hw::TreeKind> parse_trees(const std::string& text);

/// Names of pictures between commas, or "all", or "none".  Throws InputError.
PictureSet parse_pictures(const std::string& text);

/// Thresholds between commas, 0 ... 255; each counts once.  Throws InputError.
std::vector<std::uint32_t> parse_references(const std::string& text);

/// Percentages between commas, above 0 and up to 100; as shares, 0 ... 1.  Throws InputError.
std::vector<double> parse_shares(const std::string& text);

/// dramsim3, ramulator or ramulator2.  Throws InputError.
MemoryTraceFormat parse_memory_trace_format(const std::string& text);

/// "KIND" or "KIND=FILE", as in `--trace perfetto=frame.pftrace`.  Throws InputError.
TraceRequest parse_trace(const std::string& text);

/// A cycle of the unit.  Throws InputError in the name of the option.
hw::Cycle parse_cycle(const std::string& option, const std::string& text);

/// "5%" is 0.05: above 0, 100% at most.  Throws InputError in the name of the option.
double parse_percent(const std::string& option, const std::string& text);

/// 0 ... 2^64 - 1.  Throws InputError.
std::uint64_t parse_seed(const std::string& text);

}  // namespace artu::sim
