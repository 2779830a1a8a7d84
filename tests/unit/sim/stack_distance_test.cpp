// Stack distances against caches that are simulated one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "sim/reuse/stack_distance.h"

namespace artu::sim {
namespace {

/// Of `size` lines, every line allowed everywhere; the least recently used one is replaced where no place is free.
class LruCache {
 public:
  explicit LruCache(std::size_t size) : size_(size) {}

  /// True on a miss.
  bool use(std::uint64_t line) {
    const bool missed = !forget(line);
    if (missed && lines_.size() == size_) lines_.erase(lines_.begin());
    lines_.push_back(line);
    return missed;
  }
  bool forget(std::uint64_t line) {
    const auto found = std::find(lines_.begin(), lines_.end(), line);
    if (found == lines_.end()) return false;
    lines_.erase(found);
    return true;
  }
  void clear() { lines_.clear(); }

 private:
  std::size_t size_;
  std::vector<std::uint64_t> lines_;  // the last one was used last
};

/// Draws requests for `lines` lines, of which some are forgotten in between, and all once in a while.
void compare(std::uint64_t seed, std::uint64_t lines, std::size_t requests, unsigned forgotten_of_100) {
  std::mt19937_64 random(seed);
  std::vector<LruCache> caches;
  for (std::size_t size = 1; size <= lines + 1; ++size) caches.emplace_back(size);
  StackDistance stack;
  for (std::size_t i = 0; i < requests; ++i) {
    const std::uint64_t line = random() % lines * (random() % 3 == 0 ? 1 : random() % lines) % lines;
    if (random() % 100 < forgotten_of_100) {
      stack.forget(line);
      for (LruCache& cache : caches) cache.forget(line);
      continue;
    }
    if (random() % 2000 == 0) {
      stack.clear();
      for (LruCache& cache : caches) cache.clear();
    }
    const std::uint64_t distance = stack.use(line);
    for (std::size_t size = 1; size <= caches.size(); ++size) {
      ASSERT_EQ(caches[size - 1].use(line), distance >= size)
          << "seed " << seed << ", request " << i << ", line " << line << ", " << size << " lines";
    }
  }
}

TEST(StackDistance, CountsTheOtherLinesUsedSince) {
  StackDistance stack;
  EXPECT_EQ(stack.use(7), StackDistance::never_used);
  EXPECT_EQ(stack.use(7), 0u);
  EXPECT_EQ(stack.use(8), StackDistance::never_used);
  EXPECT_EQ(stack.use(8), 0u);
  EXPECT_EQ(stack.use(9), StackDistance::never_used);
  EXPECT_EQ(stack.use(8), 1u);
  EXPECT_EQ(stack.use(7), 2u);
  stack.clear();
  EXPECT_EQ(stack.use(7), StackDistance::never_used);
}

TEST(StackDistance, TellsTheMissesOfLruCachesOfEverySize) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) compare(seed, 1 + seed * 3, 3000, 0);
}

TEST(StackDistance, TellsThemWhereLinesAreForgotten) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    compare(seed, 1 + seed * 3, 3000, 5 + 2 * static_cast<unsigned>(seed));
}

/// A place that a forgotten line leaves is taken before another line is lost.
TEST(StackDistance, AForgottenLinesPlaceIsTakenByTheNextThatIsFetched) {
  StackDistance stack;
  for (const std::uint64_t line : {1, 2, 3}) stack.use(line);
  stack.forget(2);
  EXPECT_EQ(stack.use(4), StackDistance::never_used);  // in the place of 2
  EXPECT_EQ(stack.use(1), 2u);                         // so that three lines still hold it
  EXPECT_EQ(stack.use(2), StackDistance::never_used);
}

/// More requests than the numbers of a first table of times.
TEST(StackDistance, ManyRequestsOfFewLinesStayExact) {
  StackDistance stack;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    ASSERT_EQ(stack.use(i % 5), i < 5 ? StackDistance::never_used : 4u) << i;
  }
}

}  // namespace
}  // namespace artu::sim
