// The memory port: when requests and answers pass it, what bytes they carry, and the base protocol.
#include "hw/border/tlm_memory_bridge.h"

#include <gmock/gmock.h>

#include "unit/hw/memory_support.h"
#include "unit/hw/tlm_support.h"

namespace artu::hw::test {
namespace {

using sc_core::SC_PS;
using sc_core::sc_time;
using ::testing::ElementsAre;

constexpr std::uint64_t base = 0x80000000, window = 64 * 1024;
const TlmStyle all_styles[] = {TlmStyle::four_phases, TlmStyle::early_end, TlmStyle::no_end, TlmStyle::response,
                               TlmStyle::completed};

/// A clock of 1 ns; a request pushed in cycle c arrives in c + 1, an answer is popped a cycle after it was given.
struct BridgeBench {
  explicit BridgeBench(TlmStyle style = TlmStyle::four_phases)
      : image(std::make_unique<MemoryImage>()),
        bridge(bench.block<TlmMemoryBridge>("bridge", *image, TlmWindow{base, window})),
        client(bench, "client", bridge, 64, 1, 1),
        memory("memory", base, window, style) {
    image->allocate(window - image->size());
    bench.timeline.in_step = true;
    bridge.bind(client.link);
    bridge.socket.bind(memory.socket);
  }
  BridgeBench& read(Cycle cycle, Address line, std::uint32_t tag = 0) {
    client.requests.push_at(cycle - 1, read_of(line, tag));
    return *this;
  }
  BridgeBench& write(Cycle cycle, Address line, std::uint64_t bytes = whole_line) {
    client.requests.push_at(cycle - 1, write_of(line, bytes));
    return *this;
  }
  std::vector<Cycle> run() {
    bench.run(10000);
    EXPECT_EQ(memory.breaches, 0u);
    return client.responses.cycles;
  }
  std::uint8_t& byte(Address address) { return image->at<std::uint8_t>(address); }

  Bench bench;
  std::unique_ptr<MemoryImage> image;
  TlmMemoryBridge& bridge;
  Client client;
  TestMemory memory;
};

TEST(TlmMemoryBridge, AnAnswerComesInTheFirstCycleAfterItIsGiven) {
  for (const TlmStyle style : all_styles) {
    for (const unsigned ps : {0, 1, 500, 999, 1000, 1001, 20000, 20500}) {
      BridgeBench b(style);
      b.memory.latency = sc_time(ps, SC_PS);
      b.read(10, 640);
      EXPECT_THAT(b.run(), ElementsAre(10 + ps / 1000 + 1 + 1)) << ps << " ps, style " << static_cast<int>(style);
      EXPECT_THAT(b.memory.requested, ElementsAre(sc_time(10000, SC_PS)));
      EXPECT_THAT(b.memory.addresses, ElementsAre(base + 640));
    }
  }
}

TEST(TlmMemoryBridge, OneRequestACycleWhereTheMemoryEndsThemAtOnce) {
  for (const TlmStyle style : {TlmStyle::four_phases, TlmStyle::early_end}) {
    BridgeBench b(style);
    b.memory.latency = sc_time(30, sc_core::SC_NS);
    for (Cycle i = 0; i < 20; ++i) b.read(10 + i, 64 * (i + 1), static_cast<std::uint32_t>(i));
    EXPECT_EQ(b.run(), every(42, 20));
    EXPECT_EQ(b.client.tags(),
              (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19}));
  }
}

TEST(TlmMemoryBridge, WithoutAnEndOfItsOwnARequestEndsWithItsAnswer) {
  for (const TlmStyle style : {TlmStyle::no_end, TlmStyle::response, TlmStyle::completed}) {
    BridgeBench b(style);
    b.memory.latency = sc_time(30, sc_core::SC_NS);
    for (Cycle i = 0; i < 5; ++i) b.read(10, 64 * (i + 1));
    EXPECT_EQ(b.run(), every(42, 5, 31));
  }
}

TEST(TlmMemoryBridge, ARequestWaitsUntilTheOneBeforeHasEnded) {
  for (const TlmStyle style : {TlmStyle::four_phases, TlmStyle::early_end}) {
    for (const unsigned ps : {0, 999, 1000, 2500}) {
      BridgeBench b(style);
      b.memory.latency = sc_time(50, sc_core::SC_NS);
      b.memory.accept = sc_time(ps, SC_PS);
      for (Cycle i = 0; i < 5; ++i) b.read(10, 64 * (i + 1));
      EXPECT_EQ(b.run(), every(10 + 52, 5, ps / 1000 + 1)) << ps;
    }
  }
}

TEST(TlmMemoryBridge, AnswersThatComeTogetherAreGivenOneACycle) {
  BridgeBench b;
  b.memory.latency_of = [](const tlm::tlm_generic_payload& p) {
    const std::uint64_t line = (p.get_address() - base) / 64;
    return sc_time(100 - static_cast<double>(line), sc_core::SC_NS);
  };
  for (Cycle i = 0; i < 8; ++i) b.read(10 + i, 64 * (i + 1), static_cast<std::uint32_t>(i));
  EXPECT_EQ(b.run(), every(10 + 99 + 1 + 1, 8)) << "all are ready at 109 ns";
  EXPECT_EQ(b.memory.ended, 8u);
}

TEST(TlmMemoryBridge, AnswersMayOvertakeEachOther) {
  BridgeBench b;
  b.memory.latency_of = [](const tlm::tlm_generic_payload& p) {
    return sc_time(p.get_address() == base + 64 ? 90 : 20, sc_core::SC_NS);
  };
  b.read(10, 64, 7).read(11, 128, 8);
  EXPECT_THAT(b.run(), ElementsAre(11 + 22, 10 + 92));
  EXPECT_THAT(b.client.tags(), ElementsAre(8, 7));
}

TEST(TlmMemoryBridge, CyclesAreTheSameWhenEveryBlockIsTickedEveryCycle) {
  std::vector<std::vector<std::uint64_t>> classes;
  std::vector<std::vector<Cycle>> cycles;
  for (const bool clocked : {false, true}) {
    BridgeBench b;
    b.bench.clock.set_clocked(clocked);
    b.memory.latency = sc_time(12300, SC_PS);
    b.memory.accept = sc_time(1500, SC_PS);
    b.client.responses.open = [](Cycle now) { return now % 7 == 0; };
    for (Cycle i = 0; i < 90; ++i) b.read(10 + 2 * i, 64 * (i + 1));
    cycles.push_back(b.run());
    classes.push_back(cycle_classes(b.bridge));
  }
  EXPECT_EQ(cycles[0], cycles[1]);
  EXPECT_EQ(classes[0], classes[1]);
}

TEST(TlmMemoryBridge, AReadBringsTheMemorysBytes) {
  for (const TlmStyle style : all_styles) {
    BridgeBench b(style);
    for (unsigned i = 0; i < 64; ++i) b.memory.bytes[640 + i] = static_cast<std::uint8_t>(i + 1);
    b.byte(639) = b.byte(704) = 99;
    b.read(10, 640).run();
    for (unsigned i = 0; i < 64; ++i) ASSERT_EQ(b.byte(640 + i), i + 1);
    EXPECT_EQ(b.byte(639), 99);
    EXPECT_EQ(b.byte(704), 99);
  }
}

TEST(TlmMemoryBridge, AReadLeavesWhatTheUnitProducesAlone) {
  BridgeBench b;
  b.memory.bytes.assign(window, 5);
  b.bridge.produce(640, 65);
  b.read(10, 576).read(11, 640).read(12, 704).read(13, 768).run();
  EXPECT_EQ(b.byte(576), 5);
  EXPECT_EQ(b.byte(640), 0);
  EXPECT_EQ(b.byte(704), 0) << "one byte of the line is the unit's";
  EXPECT_EQ(b.byte(768), 5);
}

TEST(TlmMemoryBridge, AWriteTakesTheEnabledBytesOfTheImage) {
  BridgeBench b;
  b.memory.bytes.assign(window, 5);
  for (unsigned i = 0; i < 128; ++i) b.byte(640 + i) = static_cast<std::uint8_t>(100 + i);
  b.write(10, 640).write(11, 704, 0x8000000000000005).run();
  for (unsigned i = 0; i < 64; ++i) ASSERT_EQ(b.memory.bytes[640 + i], 100 + i);
  for (unsigned i = 0; i < 64; ++i) {
    const bool enabled = i == 0 || i == 2 || i == 63;
    ASSERT_EQ(b.memory.bytes[704 + i], enabled ? 164 + i : 5) << i;
  }
  EXPECT_EQ(b.bridge.write_bytes(), 128u);
  EXPECT_EQ(b.bridge.read_bytes(), 0u);
}

TEST(TlmMemoryBridge, DebugAccessLoadsInNoTime) {
  BridgeBench b;
  b.memory.bytes.assign(window, 5);
  EXPECT_TRUE(b.bridge.load(128, 4096));
  EXPECT_EQ(b.byte(127), 0);
  EXPECT_EQ(b.byte(128), 5);
  EXPECT_EQ(b.byte(128 + 4095), 5);
  EXPECT_EQ(b.byte(128 + 4096), 0);
  EXPECT_TRUE(b.bridge.load(0, 0));
  b.memory.debug = false;
  EXPECT_FALSE(b.bridge.load(128, 64));
}

TEST(TlmMemoryBridge, AnErrorOfTheMemoryEndsTheFrame) {
  for (const TlmStyle style : all_styles) {
    BridgeBench b(style);
    b.memory.latency = sc_time(20, sc_core::SC_NS);
    b.memory.status_of = [](const tlm::tlm_generic_payload& p) {
      return p.get_address() == base + 128 ? tlm::TLM_ADDRESS_ERROR_RESPONSE : tlm::TLM_OK_RESPONSE;
    };
    for (Cycle i = 0; i < 5; ++i) b.read(10 + i, 64 * (i + 1));
    b.run();
    EXPECT_EQ(b.bridge.failure(), TlmMemoryBridge::Failure::response);
    EXPECT_EQ(b.bridge.failed_at(), 128u);
    EXPECT_LE(b.client.responses.cycles.size(), 1u);
    int drained = 0;
    b.bridge.drain([&] { ++drained; });
    if (sc_core::sc_pending_activity()) sc_core::sc_start();
    EXPECT_EQ(drained, 1) << "the answers that were under way have come";
    EXPECT_EQ(b.memory.breaches, 0u);
    EXPECT_TRUE(style == TlmStyle::completed || b.memory.ended == b.memory.addresses.size());
  }
}

TEST(TlmMemoryBridge, ALineOutsideOfTheWindowEndsTheFrameAndIsNotAsked) {
  for (const Address line : {window, ~Address{63}}) {
    BridgeBench b;
    b.read(10, window - 64).read(20, line).run();
    EXPECT_EQ(b.bridge.failure(), TlmMemoryBridge::Failure::address);
    EXPECT_EQ(b.bridge.failed_at(), line);
    EXPECT_THAT(b.memory.addresses, ElementsAre(base + window - 64));
  }
}

TEST(TlmPayloadPool, TransactionsAreReusedWhenTheLastHolderLetsGo) {
  TlmPayloadPool pool;
  LineTransaction& a = pool.acquire(read_of(64), 64);
  a.acquire();  // an observer
  a.release();
  EXPECT_EQ(pool.in_use(), 1u);
  LineTransaction& b = pool.acquire(write_of(128, 6), 128);
  EXPECT_EQ(pool.size(), 2u);
  EXPECT_EQ(b.get_byte_enable_length(), 64u);
  a.release();
  b.release();
  EXPECT_EQ(pool.in_use(), 0u);
  LineTransaction& again = pool.acquire(read_of(192), 192);
  EXPECT_EQ(pool.size(), 2u);
  EXPECT_EQ(again.get_byte_enable_ptr(), nullptr);
  EXPECT_TRUE(again.is_read());
  again.release();
}

}  // namespace
}  // namespace artu::hw::test
