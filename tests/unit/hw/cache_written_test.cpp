// A cache whose lines another block writes below: old lines are forgotten before those who wait are told.
#include <gtest/gtest.h>

#include "unit/hw/memory_support.h"

namespace artu::hw::test {
namespace {

const CacheConfig small{512, 2, 2, 4, 4};  // 4 sets of 2 ways

struct Written : CacheBench {
  Written() : CacheBench(small) {
    written.bind(source, cache);
    forgotten.bind(cache, sink);
    cache.bind_written(written, forgotten);
  }
  Fifo<LineWritten>& written = bench.fifo<LineWritten>("written", 4);
  Fifo<LineWritten>& forgotten = bench.fifo<LineWritten>("forgotten", 4);
  Source<LineWritten>& source = bench.block<Source<LineWritten>>("source", written);
  Sink<LineWritten>& sink = bench.block<Sink<LineWritten>>("sink", forgotten);
};

TEST(CacheWritten, ALineThatWasWrittenIsFetchedAgain) {
  Written b;
  b.client().requests.push_at(1, read_of(b.line(0, 0))).push_at(200, read_of(b.line(0, 0)));
  b.client().requests.push_at(300, read_of(b.line(0, 0)));
  b.source.push_at(250, {b.line(0, 0), 1});
  b.bench.run(500);
  EXPECT_EQ(b.memory.lines(), (std::vector<Address>{b.line(0, 0), b.line(0, 0)}));
  EXPECT_EQ(b.client().responses.tokens.size(), 3u);
  EXPECT_EQ(counter(b.cache, "invalidations"), 1u);
}

TEST(CacheWritten, OtherLinesStay) {
  Written b;
  b.client().requests.push_at(1, read_of(b.line(0, 0))).push_at(300, read_of(b.line(0, 0)));
  b.source.push_at(250, {b.line(0, 1), 1}).push_at(251, {b.line(1, 0), 1});
  b.bench.run(500);
  EXPECT_EQ(b.memory.requests.size(), 1u);
  EXPECT_EQ(counter(b.cache, "invalidations"), 0u);
}

TEST(CacheWritten, ItIsHandedOnOneACycleInTheCycleAfterItsArrival) {
  Written b;
  for (std::uint64_t i = 0; i < 20; ++i) b.source.push_at(9, {b.line(0, 0), i + 1});
  b.bench.run(200);
  EXPECT_EQ(b.sink.cycles, every(11, 20));
  for (std::uint64_t i = 0; i < 20; ++i) EXPECT_EQ(b.sink.tokens[i].bytes, i + 1);
}

TEST(CacheWritten, ALookUpOfTheSameCycleFindsItForgotten) {
  Written b;
  b.client().requests.push_at(1, read_of(b.line(0, 0))).push_at(100, read_of(b.line(0, 0)));
  b.source.push_at(100, {b.line(0, 0), 1});
  b.bench.run(300);
  EXPECT_EQ(b.memory.requests.size(), 2u);
}

TEST(CacheWritten, ALineOnItsWayIsAnsweredButNotKept) {
  Written b;
  b.client().requests.push_at(1, read_of(b.line(0, 0), 7));
  b.source.push_at(5, {b.line(0, 0), 1});
  // The next one must not join it: what comes may have been read before the write.
  b.client().requests.push_at(10, read_of(b.line(0, 0), 8));
  b.client().requests.push_at(200, read_of(b.line(0, 0), 9));
  b.bench.run(400);
  EXPECT_EQ(b.memory.lines(), (std::vector<Address>{b.line(0, 0), b.line(0, 0)}));
  EXPECT_EQ(b.client().tags(), (std::vector<std::uint32_t>{7, 8, 9}));
  EXPECT_EQ(b.cache.hits(), 1u) << "what the second fetch brought is new";
}

TEST(CacheWritten, WaitsWhereItCannotHandOn) {
  Written b;
  b.sink.open = [](Cycle now) { return now >= 100; };
  b.client().requests.push_at(1, read_of(b.line(0, 0))).push_at(60, read_of(b.line(0, 0)));
  for (std::uint64_t i = 0; i < 8; ++i) b.source.push_at(30, {b.line(1, 0), i + 1});
  b.bench.run(300);
  EXPECT_EQ(b.sink.tokens.size(), 8u);
  EXPECT_EQ(b.client().responses.tokens.size(), 2u) << "look-ups go on";
  EXPECT_LT(b.client().responses.cycles[1], 70u);
}

}  // namespace
}  // namespace artu::hw::test
