#include "sim/report/memory_trace.h"

#include <fmt/format.h>

namespace artu::sim {

std::string memory_trace_line(MemoryTraceFormat format, hw::Cycle cycle, const hw::MemoryRequest& request) {
  switch (format) {
    case MemoryTraceFormat::dramsim3:
      return fmt::format("0x{:x} {} {}\n", request.line, request.write() ? "WRITE" : "READ", cycle);
    case MemoryTraceFormat::ramulator:
      return fmt::format("0x{:x} {}\n", request.line, request.write() ? 'W' : 'R');
    case MemoryTraceFormat::ramulator2:
      return fmt::format("{} 0x{:x}\n", request.write() ? "ST" : "LD", request.line);
  }
  return {};
}

MemoryTrace::MemoryTrace(const std::string& name, MemoryTraceFormat format, bool force)
    : format_(format), file_(name, force) {}

hw::MemoryObserver MemoryTrace::observer() {
  return [this](hw::Cycle cycle, const hw::MemoryRequest& request) { add(cycle, request); };
}

void MemoryTrace::add(hw::Cycle cycle, const hw::MemoryRequest& request) noexcept {
  if (failure_) return;
  try {
    file_.write(memory_trace_line(format_, begin_ + cycle, request));
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void MemoryTrace::end_frame(hw::Cycle clocks) {
  if (failure_) std::rethrow_exception(failure_);
  begin_ += clocks;
}

void MemoryTrace::close() { file_.close(); }

}  // namespace artu::sim
