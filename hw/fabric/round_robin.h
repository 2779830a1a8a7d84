// Round-robin choice: the one after the last that was granted comes first.
#pragma once

#include <cstddef>

namespace artu::hw {

class RoundRobin {
 public:
  void reset() { next_ = 0; }
  /// First of `count` for which `wants(i)` holds, from the pointer on; `count` if none.  Does not move the pointer.
  template <class Wants>
  std::size_t pick(std::size_t count, Wants wants) const {
    for (std::size_t i = next_; i < count; ++i) {
      if (wants(i)) return i;
    }
    for (std::size_t i = 0; i < next_ && i < count; ++i) {
      if (wants(i)) return i;
    }
    return count;
  }
  void granted(std::size_t i, std::size_t count) { next_ = i + 1 == count ? 0 : i + 1; }

 private:
  std::size_t next_ = 0;
};

}  // namespace artu::hw
