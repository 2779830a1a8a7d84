// Writes through a cache: allocation, write-back, flush.
#include <gtest/gtest.h>

#include "hw/memory/dram.h"
#include "unit/hw/memory_support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle memory_latency = CacheBench::memory_latency;
const CacheConfig small{512, 2, 2, 4, 4};  // 4 sets of 2 ways

TEST(CacheWrite, AWholeLineIsTakenWithoutAFetchAndAnsweredLikeAHit) {
  CacheBench b(small);
  b.client().requests.push_at(1, write_of(b.line(0, 0), whole_line));
  b.bench.run(100);
  EXPECT_EQ(b.client().responses.cycles, std::vector<Cycle>{2 + 2});
  EXPECT_TRUE(b.memory.requests.empty());
  EXPECT_EQ(b.cache.misses(), 1u);
}

TEST(CacheWrite, APartOfALineFetchesTheRest) {
  CacheBench b(small);
  b.client().requests.push_at(1, write_of(b.line(0, 0), 0xf));
  b.bench.run(100);
  EXPECT_EQ(b.client().responses.cycles, std::vector<Cycle>{3 + memory_latency + 2});
  ASSERT_EQ(b.memory.requests.size(), 1u);
  EXPECT_FALSE(b.memory.requests[0].write());
}

TEST(CacheWrite, ADirtyVictimIsWrittenBackAndACleanOneIsNot) {
  CacheBench b(small);
  b.client().requests.push_at(1, write_of(b.line(0, 0), whole_line)).push_at(100, read_of(b.line(0, 1)));
  b.client().requests.push_at(200, read_of(b.line(0, 2)));  // replaces 0
  b.client().requests.push_at(300, read_of(b.line(0, 3)));  // replaces 1
  b.bench.run(400);
  EXPECT_EQ(b.memory.lines(), (std::vector<Address>{b.line(0, 1), b.line(0, 2), b.line(0, 0), b.line(0, 3)}));
  EXPECT_EQ(b.memory.writes(), 1u);
  EXPECT_EQ(b.memory.requests[2].bytes, whole_line);
  // The victim leaves when the line arrives.
  EXPECT_EQ(b.memory.cycles[2], b.memory.cycles[1] + memory_latency + 1);
}

TEST(CacheWrite, AWriteHitMakesTheLineDirty) {
  CacheBench b(small);
  b.client().requests.push_at(1, read_of(b.line(0, 0))).push_at(100, write_of(b.line(0, 0), 1));
  b.client().requests.push_at(200, read_of(b.line(0, 1))).push_at(300, read_of(b.line(0, 2)));
  b.bench.run(400);
  EXPECT_EQ(b.cache.write_backs(), 1u);
}

TEST(CacheWrite, AWriteMergedIntoAnOutstandingReadMakesTheLineDirty) {
  for (std::uint64_t bytes : {std::uint64_t{1}, whole_line}) {
    CacheBench b(small);
    b.client().requests.push_at(1, read_of(b.line(0, 0))).push_at(5, write_of(b.line(0, 0), bytes));
    b.client().requests.push_at(200, read_of(b.line(0, 1))).push_at(300, read_of(b.line(0, 2)));
    b.bench.run(400);
    EXPECT_EQ(b.cache.fills(), 3u);
    EXPECT_EQ(b.cache.write_backs(), 1u);
  }
}

TEST(CacheWrite, WholeLinesStreamThroughAtOneACycle) {
  // Twice the capacity: the second half throws the first one out.
  CacheBench b({512, 2, 2, 32, 4});
  b.memory.open = nullptr;
  for (std::uint32_t i = 0; i < 16; ++i) b.client().requests.push_at(1 + i, write_of(4096 + i * 64, whole_line, i));
  b.bench.run(200);
  EXPECT_EQ(b.client().responses.cycles, every(4, 16));
  EXPECT_EQ(b.memory.writes(), 8u);
}

struct Flush : testing::Test {
  Flush() {
    b.cache.bind_flush(flush, flushed);
    flush.bind(command, b.cache);
    flushed.bind(b.cache, answer);
  }
  CacheBench b{small};
  Fifo<CacheCommand>& flush = b.bench.fifo<CacheCommand>("flush", 2);
  Fifo<CacheCommand>& flushed = b.bench.fifo<CacheCommand>("flushed", 2);
  Source<CacheCommand>& command = b.bench.block<Source<CacheCommand>>("command", flush);
  Sink<CacheCommand>& answer = b.bench.block<Sink<CacheCommand>>("answer", flushed);
};

TEST_F(Flush, WritesAllDirtyLinesOneACycleAndAnswersWhenTheMemoryHasThem) {
  for (std::uint32_t i = 0; i < 4; ++i) b.client().requests.push_at(1 + i, write_of(b.line(i, 0), whole_line));
  b.client().requests.push_at(10, read_of(b.line(0, 1)));  // clean: stays
  command.push_at(99, {});
  b.bench.run(300);
  EXPECT_EQ(b.memory.writes(), 4u);
  // Command 100, first line out in the same cycle, last one 103, at the memory 104, acknowledged 20 later.
  EXPECT_EQ(b.memory.cycles, (std::vector<Cycle>{12, 101, 102, 103, 104}));
  EXPECT_EQ(answer.cycles, std::vector<Cycle>{104 + memory_latency + 1});
  EXPECT_TRUE(b.cache.quiet());
}

TEST_F(Flush, WithoutDirtyLinesIsAnsweredAtOnce) {
  command.push_at(99, {});
  b.bench.run(300);
  EXPECT_EQ(answer.cycles, std::vector<Cycle>{101});
  EXPECT_TRUE(b.memory.requests.empty());
}

TEST_F(Flush, IsNotAnsweredBeforeTheSlowestAcknowledgement) {
  b.memory.latency = [this](const MemoryRequest& r) -> Cycle { return r.line == b.line(2, 0) ? 500 : 10; };
  for (std::uint32_t i = 0; i < 4; ++i) b.client().requests.push_at(1 + i, write_of(b.line(i, 0), whole_line));
  command.push_at(99, {});
  b.bench.run(599 + 4);
  EXPECT_TRUE(answer.cycles.empty());
  b.bench.run(599 + 6);
  EXPECT_EQ(answer.cycles, std::vector<Cycle>{103 + 500 + 1});
}

TEST_F(Flush, ASecondOneFindsTheLinesClean) {
  b.client().requests.push_at(1, write_of(b.line(0, 0), whole_line));
  command.push_at(99, {}).push_at(199, {});
  b.bench.run(300);
  EXPECT_EQ(b.memory.writes(), 1u);
  EXPECT_EQ(answer.cycles.size(), 2u);
}

}  // namespace
}  // namespace artu::hw::test
