// How much memory the process needs on the host, in bytes of what is resident.
#pragma once

#include <cstdint>

namespace artu::sim {

/// Now, and the most since the program began or since restart_peak().  0 where the system does not tell.
std::uint64_t resident_bytes();
std::uint64_t peak_bytes();
/// From now on peak_bytes() is the most since now; where the system cannot, since the program began.
void restart_peak();

/// Of a run.  Several processes: of the one that needed most, with what it shares with the others.
struct MemoryUse {
  std::uint64_t peak = 0;  // the most at any time
  std::uint64_t loading =
      0;                     // the most while the scene was loaded and its trees were built, less what there was before
  std::uint64_t frames = 0;  // the most while frames were simulated, less what there was before them

  void keep_larger(const MemoryUse& other);
};

/// The parts of a run, measured one after the other.
class MemoryMeter {
 public:
  MemoryMeter();  // before loading
  void loaded();
  MemoryUse use() const;  // after a frame, in any process

 private:
  std::uint64_t before_ = 0, before_frames_ = 0;
  MemoryUse use_;
};

}  // namespace artu::sim
