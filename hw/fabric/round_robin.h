// Round-robin choice: the one after the last that was granted comes first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace artu::hw {

class RoundRobin {
 public:
  void reset() { next_ = 0; }
  /// The one that comes first.
  std::size_t pointer() const { return next_; }
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
  /// The same, looking only at those whose flag is set (bit i of the words, as Channel::flag keeps them).
  template <class Wants>
  std::size_t pick(const std::vector<std::uint64_t>& flags, std::size_t count, Wants wants) const {
    const std::size_t words = flags.size();
    const std::size_t first = next_ / 64;
    const std::uint64_t from = ~std::uint64_t{0} << (next_ % 64);
    for (std::size_t n = 0; n <= words; ++n) {
      const std::size_t word = (first + n) % words;
      std::uint64_t bits = flags[word];
      if (n == 0) bits &= from;
      if (n == words) bits &= ~from;
      for (; bits != 0; bits &= bits - 1) {
        const std::size_t i = word * 64 + static_cast<std::size_t>(__builtin_ctzll(bits));
        if (wants(i)) return i;
      }
    }
    return count;
  }
  void granted(std::size_t i, std::size_t count) { next_ = i + 1 == count ? 0 : i + 1; }

 private:
  std::size_t next_ = 0;
};

}  // namespace artu::hw
