// `--memory-trace`: every request that reaches the DRAM, in the formats that DRAM simulators read
// (docs/memory_trace.md).
#pragma once

#include <exception>
#include <string>

#include "hw/memory/dram.h"
#include "sim/report/file.h"

namespace artu::sim {

enum class MemoryTraceFormat : std::uint8_t { dramsim3, ramulator, ramulator2 };

/// One line a request, with its end.
std::string memory_trace_line(MemoryTraceFormat format, hw::Cycle cycle, const hw::MemoryRequest& request);

/// The frames of a run one after the other: a frame's clocks begin where those of the one before end.
class MemoryTrace {
 public:
  /// Refuses a file that exists, unless `force`.
  MemoryTrace(const std::string& name, MemoryTraceFormat format, bool force);
  /// To be told of the requests of the present frame.
  hw::MemoryObserver observer();
  /// The frame took this many DRAM clocks.  Throws InputError where a request of it could not be written.
  void end_frame(hw::Cycle clocks);
  /// Without it nothing is left.
  void close();

 private:
  void add(hw::Cycle cycle, const hw::MemoryRequest& request) noexcept;

  const MemoryTraceFormat format_;
  AtomicFile file_;
  hw::Cycle begin_ = 0;         // of the present frame
  std::exception_ptr failure_;  // no exception may pass through the SystemC kernel
};

}  // namespace artu::sim
