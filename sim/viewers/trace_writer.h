// What the writers of all trace formats have in common: a file that is written whole or not at all, failures that come
// out at the end of the frame, and what was written of how many cycles.
#pragma once

#include <exception>
#include <string>
#include <string_view>

#include "hw/watch/activity.h"
#include "sim/report/file.h"

namespace artu::sim {

class TraceWriter : public hw::ActivitySink {
 public:
  TraceWriter(const std::string& name, bool force) : name_(name), file_(name, force) {}

  /// Throws InputError where the trace could not be written; without it nothing is left.
  void close();

  const std::string& name() const { return name_; }
  std::uint64_t bytes() const { return bytes_; }
  /// Of the unit, in the file.
  hw::Cycle cycles() const { return cycles_; }

 protected:
  /// Keeps a failure for close(): no exception may pass through the SystemC kernel.
  void write(std::string_view text) noexcept;
  void covers(hw::Tick begin, hw::Tick end, hw::Tick unit_period) { cycles_ = (end - begin) / unit_period; }

 private:
  const std::string name_;
  AtomicFile file_;
  std::uint64_t bytes_ = 0;
  hw::Cycle cycles_ = 0;
  std::exception_ptr failure_;
};

}  // namespace artu::sim
