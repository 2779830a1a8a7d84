#include "sim/report/memory_use.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace artu::sim {
namespace {

/// Linux tells in lines as "VmHWM:   123456 kB".
std::uint64_t status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == name && file >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

std::uint64_t less(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : 0; }

}  // namespace

std::uint64_t resident_bytes() { return status("VmRSS:"); }
std::uint64_t peak_bytes() { return status("VmHWM:"); }
void restart_peak() { std::ofstream("/proc/self/clear_refs") << 5 << std::flush; }

void MemoryUse::keep_larger(const MemoryUse& other) {
  peak = std::max(peak, other.peak);
  loading = std::max(loading, other.loading);
  frames = std::max(frames, other.frames);
}

MemoryMeter::MemoryMeter() : before_(resident_bytes()) { restart_peak(); }

void MemoryMeter::loaded() {
  use_.peak = peak_bytes();
  use_.loading = less(use_.peak, before_);
  before_frames_ = resident_bytes();
  restart_peak();
}

MemoryUse MemoryMeter::use() const {
  MemoryUse use = use_;
  const std::uint64_t peak = peak_bytes();
  use.peak = std::max(use.peak, peak);
  use.frames = less(peak, before_frames_);
  return use;
}

}  // namespace artu::sim
