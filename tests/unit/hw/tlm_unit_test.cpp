// The whole unit behind TLM-2.0: its registers, its interrupt, its memory, and that the border changes no pixel.
#include "hw/border/tlm_ray_tracing_unit.h"

#include <gmock/gmock.h>

#include "unit/hw/tiny_frame.h"
#include "unit/hw/tlm_support.h"

namespace artu::hw::test {
namespace {

namespace reg = control_register;
using sc_core::SC_NS;
using sc_core::sc_time;

constexpr std::uint64_t base = 0x40000000, window = 64 * 1024;

/// A platform of a host, a memory that holds a tiny frame, and the unit.
struct Platform {
  explicit Platform(TlmStyle style = TlmStyle::four_phases, const RunMode& mode = {},
                    const UnitConfig& config = TinyUnit::small())
      : tiny(21, 13),
        records(21 * 13),
        host("host"),
        memory("memory", base, window, style),
        unit("unit", config, mode, TlmWindow{base, window}),
        interrupt("interrupt") {
    host.socket.bind(unit.registers);
    unit.memory.bind(memory.socket);
    unit.interrupt.bind(interrupt);
    unit.observe(&records);
    memory.latency = sc_time(100, SC_NS);
    lay_down();
    sc_core::sc_start(sc_core::SC_ZERO_TIME);
  }
  /// The image of the frame as software would write it into the memory.
  void lay_down() {
    EXPECT_LE(tiny.image.size(), window);
    std::memcpy(&memory.bytes[64], &tiny.image.at<std::uint8_t>(64), tiny.image.size() - 64);
  }
  void start() {
    host.write(reg::descriptor_lo, static_cast<std::uint32_t>(tiny.descriptor));
    host.write(reg::descriptor_hi, 0);
    host.delay = sc_core::SC_ZERO_TIME;
    EXPECT_EQ(host.write(reg::control, control_start | control_interrupt_enable), tlm::TLM_OK_RESPONSE);
  }
  /// From the start to where nothing happens any more; returns the status.
  std::uint32_t run() {
    records.assign(records.size(), {});
    start();
    sc_core::sc_start();
    EXPECT_EQ(memory.breaches, 0u);
    return host.read(reg::status);
  }
  std::uint64_t cycles() { return host.read(reg::cycles_lo) | std::uint64_t{host.read(reg::cycles_hi)} << 32; }
  FrameDescriptor& frame() { return *reinterpret_cast<FrameDescriptor*>(&memory.bytes[tiny.descriptor]); }
  std::vector<std::uint8_t> range(Address begin, std::uint64_t bytes) const {
    return {memory.bytes.begin() + static_cast<long>(begin), memory.bytes.begin() + static_cast<long>(begin + bytes)};
  }

  SimulationContext context;
  TinyFrame tiny;
  PixelRecords records;
  TestHost host;
  TestMemory memory;
  TlmRayTracingUnit unit;
  sc_core::sc_signal<bool> interrupt;
};

std::vector<PixelTuple> tuples(const PixelRecords& records) {
  std::vector<PixelTuple> result;
  for (const PixelRecord& r : records) {
    result.emplace_back(r.pass, static_cast<int>(r.hit_class), r.n_static, r.n_dynamic, r.threshold, r.difference,
                        static_cast<int>(r.decision), r.r, r.g, r.b, r.primitive, r.t_bits);
  }
  return result;
}

TEST(TlmUnit, ThePictureIsThatOfTheBuiltInDramWhateverTheMemoryDoes) {
  TinyUnit built_in;
  built_in.run();
  const FrameDescriptor& f = built_in.tiny.frame();
  for (const TlmStyle style : {TlmStyle::four_phases, TlmStyle::early_end, TlmStyle::no_end, TlmStyle::completed}) {
    for (const double latency : {0.0, 3.7, 200.0}) {
      Platform p(style);
      p.memory.latency = sc_time(latency, SC_NS);
      ASSERT_EQ(p.run(), status_done);
      EXPECT_EQ(tuples(p.records), built_in.pixels());
      for (std::uint32_t y = 0; y < f.height; ++y) {
        for (std::uint32_t x = 0; x < f.width; ++x) {
          const std::uint64_t i = std::uint64_t{y} * f.pitch + x;
          ASSERT_EQ(p.range(f.frame_buffer + i * 4, 4),
                    (std::vector<std::uint8_t>{p.records[y * 21 + x].r, p.records[y * 21 + x].g,
                                               p.records[y * 21 + x].b, 255}));
          ASSERT_EQ(p.memory.bytes[f.hit_classes + i], static_cast<int>(p.records[y * 21 + x].hit_class));
        }
      }
    }
  }
}

TEST(TlmUnit, ThePictureIsTheSameWithABankedL2) {
  UnitConfig config = TinyUnit::small();
  config.memory.l2_banks = 4;
  TinyUnit built_in(21, 13, {}, config);
  built_in.run();
  Platform p(TlmStyle::four_phases, {}, config);
  ASSERT_EQ(p.run(), status_done);
  EXPECT_EQ(tuples(p.records), built_in.pixels());
}

TEST(TlmUnit, OnlyPixelsAreWritten) {
  Platform p;
  p.memory.bytes.assign(window, 0xcd);
  p.lay_down();
  const FrameDescriptor f = p.frame();
  // Padding of the rows, which the driver zeroes, is software's.
  std::vector<std::uint8_t> before = p.memory.bytes;
  std::fill_n(before.begin() + static_cast<long>(f.frame_buffer), f.pitch * f.height * 4, 0xab);
  std::fill_n(before.begin() + static_cast<long>(f.hit_classes), f.pitch * f.height, 0xab);
  p.memory.bytes = before;
  ASSERT_EQ(p.run(), status_done);
  for (std::uint32_t y = 0; y < f.height; ++y) {
    for (std::uint32_t x = 0; x < f.width; ++x) {
      const std::uint64_t i = std::uint64_t{y} * f.pitch + x;
      std::copy_n(&p.memory.bytes[f.frame_buffer + i * 4], 4, &before[f.frame_buffer + i * 4]);
      before[f.hit_classes + i] = p.memory.bytes[f.hit_classes + i];
    }
  }
  EXPECT_EQ(p.memory.bytes, before);
}

TEST(TlmUnit, AFrameSeesWhatSoftwareHasChangedInTheMemory) {
  TinyUnit built_in;
  Platform p;
  ASSERT_EQ(p.run(), status_done);
  const Address materials = p.frame().materials;
  for (MaterialRecord* wall : {&built_in.tiny.image.at<MaterialRecord>(materials),
                               reinterpret_cast<MaterialRecord*>(&p.memory.bytes[materials])}) {
    wall->diffuse = {0.1f, 0.9f, 0.2f};
  }
  const std::vector<PixelTuple> before = tuples(p.records);
  built_in.run();
  p.context.enter();
  ASSERT_EQ(p.run(), status_done);
  EXPECT_EQ(tuples(p.records), built_in.pixels());
  EXPECT_NE(tuples(p.records), before);
}

TEST(TlmUnit, TheTreeThatIsBuiltStaysAsItWasLaidDown) {
  TinyUnit built_in;
  built_in.tiny.frame().dynamic_moved = 1;
  built_in.run();
  Platform p;
  p.frame().dynamic_moved = 1;
  const FrameDescriptor f = p.frame();
  const std::vector<std::uint8_t> nodes = p.range(f.dynamic_nodes, 64), triangles = p.range(f.dynamic_triangles, 64);
  ASSERT_EQ(p.run(), status_done);
  EXPECT_EQ(tuples(p.records), built_in.pixels());
  EXPECT_EQ(p.range(f.dynamic_nodes, 64), nodes);
  EXPECT_EQ(p.range(f.dynamic_triangles, 64), triangles);
}

TEST(TlmUnit, CyclesDependOnTheMemoryAloneAndNotOnWhenAFrameStarts) {
  std::vector<std::uint64_t> cycles;
  for (const double latency : {50.0, 100.0, 200.0}) {
    Platform p;
    p.memory.latency = sc_time(latency, SC_NS);
    ASSERT_EQ(p.run(), status_done);
    cycles.push_back(p.cycles());
    const std::vector<std::uint64_t> addresses = p.memory.addresses;
    for (const double wait : {1000.0, 3.3}) {
      sc_core::sc_start(sc_time(wait, SC_NS));
      p.memory.addresses.clear();
      ASSERT_EQ(p.run(), status_done);
      EXPECT_EQ(p.cycles(), cycles.back());
      EXPECT_EQ(p.memory.addresses, addresses);
    }
  }
  EXPECT_LT(cycles[0], cycles[1]);
  EXPECT_LT(cycles[1], cycles[2]);
}

TEST(TlmUnit, HowTheModelIsRunChangesNoCycle) {
  std::vector<std::uint64_t> cycles;
  std::vector<std::vector<std::uint64_t>> addresses;
  RunMode clocked, shuffled;
  clocked.clocked = true;
  shuffled.shuffle = true;
  for (const RunMode& mode : {RunMode{}, clocked, shuffled}) {
    Platform p(TlmStyle::four_phases, mode);
    ASSERT_EQ(p.run(), status_done);
    cycles.push_back(p.cycles());
    addresses.push_back(p.memory.addresses);
  }
  EXPECT_EQ(cycles, std::vector<std::uint64_t>(3, cycles[0]));
  EXPECT_EQ(addresses[0], addresses[1]);
  EXPECT_EQ(addresses[0], addresses[2]);
}

TEST(TlmUnit, AFrameLastsItsCyclesAfterTheAccessThatStartsIt) {
  Platform p;
  sc_core::sc_start(sc_time(123, SC_NS));
  p.start();
  EXPECT_EQ(p.host.delay, sc_time(2, SC_NS)) << "an access takes a clock of 500 MHz";
  EXPECT_EQ(p.host.read(reg::status), status_running);
  const sc_time begin = sc_core::sc_time_stamp() + sc_time(2, SC_NS);
  while (!p.interrupt.read()) sc_core::sc_start(sc_time(1, SC_NS));
  EXPECT_EQ(sc_core::sc_time_stamp(), begin + sc_time(2.0 * static_cast<double>(p.cycles()), SC_NS) + sc_time(1, SC_NS))
      << "the signal is seen at the end of the step of 1 ns after the one in which it changes";
}

TEST(TlmUnit, KeepingToKernelTimeChangesNoCycle) {
  TinyUnit ahead, in_step;
  const FrameResult expected = ahead.run();
  in_step.context.enter();
  int ended = 0;
  in_step.unit.keep_to_kernel_time([&] { ++ended; });
  in_step.unit.begin_frame(in_step.tiny.descriptor, &in_step.records);
  sc_core::sc_start();
  const FrameResult result = in_step.unit.end_frame();
  EXPECT_GE(ended, 1);
  EXPECT_EQ(result.cycles, expected.cycles);
  EXPECT_EQ(sc_core::sc_time_stamp(), sc_time(2.0 * static_cast<double>(result.cycles), SC_NS));
  ASSERT_EQ(result.statistics.size(), expected.statistics.size());
  for (std::size_t i = 0; i < result.statistics.size(); ++i) {
    EXPECT_EQ(result.statistics[i].value, expected.statistics[i].value) << result.statistics[i].name;
  }
}

TEST(TlmUnit, RegistersAreAsDocumented) {
  Platform p;
  EXPECT_EQ(p.host.read(reg::id), 0x55545241u);
  EXPECT_EQ(p.host.read(reg::version), 0x00010000u);
  EXPECT_EQ(p.host.read(reg::status), 0u);
  EXPECT_EQ(p.host.read(reg::counters), p.unit.counter_names().size());
  p.host.write(reg::descriptor_lo, 0x89abcdc0);
  p.host.write(reg::descriptor_hi, 0x1234567);
  EXPECT_EQ(p.host.read(reg::descriptor_lo), 0x89abcdc0u);
  EXPECT_EQ(p.host.read(reg::descriptor_hi), 0x1234567u);
  p.host.write(reg::control, control_interrupt_enable | 0xfffffff8);
  EXPECT_EQ(p.host.read(reg::control), control_interrupt_enable);
  for (const std::uint32_t read_only : {reg::id, reg::version, reg::status, reg::cycles_lo, reg::cycles_hi,
                                        reg::counters, reg::counter_lo, reg::counter_hi}) {
    EXPECT_EQ(p.host.write(read_only, 1), tlm::TLM_COMMAND_ERROR_RESPONSE) << read_only;
  }
}

TEST(TlmUnit, WrongAccessesAreAnsweredAsTlmSays) {
  Platform p;
  std::uint32_t v = 0;
  unsigned char enables[4] = {0xff, 0xff, 0xff, 0xff};
  const auto read = tlm::TLM_READ_COMMAND;
  EXPECT_EQ(p.host.access(read, reg::id, v), tlm::TLM_OK_RESPONSE);
  EXPECT_EQ(p.host.access(tlm::TLM_IGNORE_COMMAND, reg::id, v), tlm::TLM_OK_RESPONSE);
  EXPECT_EQ(p.host.access(read, reg::bytes, v), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(p.host.access(read, ~std::uint64_t{3}, v), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(p.host.access(read, 2, v), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(p.host.access(read, 0, v, 2), tlm::TLM_BURST_ERROR_RESPONSE);
  EXPECT_EQ(p.host.access(read, 0, v, 8, nullptr, 8), tlm::TLM_BURST_ERROR_RESPONSE);
  EXPECT_EQ(p.host.access(read, 0, v, 4, nullptr, 2), tlm::TLM_BURST_ERROR_RESPONSE);
  EXPECT_EQ(p.host.access(read, 0, v, 4, enables), tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
  EXPECT_EQ(p.host.write(reg::counter_select, p.host.read(reg::counters)), tlm::TLM_GENERIC_ERROR_RESPONSE);
}

TEST(TlmUnit, DebugAccessReadsAndChangesNothing) {
  Platform p;
  std::uint8_t bytes[64] = {};
  tlm::tlm_generic_payload payload;
  payload.set_command(tlm::TLM_READ_COMMAND);
  payload.set_address(2);
  payload.set_data_ptr(bytes);
  payload.set_data_length(64);
  EXPECT_EQ(p.host.socket->transport_dbg(payload), reg::bytes - 2);
  EXPECT_EQ(bytes[0], 'T');
  EXPECT_EQ(bytes[1], 'U');
  EXPECT_EQ(bytes[4], 1) << "version 1.0";
  payload.set_command(tlm::TLM_WRITE_COMMAND);
  EXPECT_EQ(p.host.socket->transport_dbg(payload), 0u);
}

TEST(TlmUnit, CountersAreThoseOfTheStatistics) {
  Platform p;
  ASSERT_EQ(p.run(), status_done);
  const Statistics& statistics = p.unit.result().statistics;
  const std::vector<std::string> names = p.unit.counter_names();
  ASSERT_EQ(p.host.read(reg::counters), statistics.size());
  std::uint64_t port_bytes = 0;
  for (std::uint32_t i = 0; i < statistics.size(); ++i) {
    EXPECT_EQ(p.host.write(reg::counter_select, i), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(p.host.read(reg::counter_select), i);
    const std::uint64_t value = p.host.read(reg::counter_lo) | std::uint64_t{p.host.read(reg::counter_hi)} << 32;
    EXPECT_EQ(value, statistics[i].value) << names[i];
    EXPECT_EQ(names[i], statistics[i].block + "." + statistics[i].name);
    if (names[i] == "memory_port.read_bytes" || names[i] == "memory_port.write_bytes") port_bytes += value;
  }
  EXPECT_EQ(port_bytes, p.memory.addresses.size() * 64);
}

TEST(TlmUnit, TheInterruptIsALevelUntilItIsCleared) {
  Platform p;
  EXPECT_FALSE(p.interrupt.read());
  p.run();
  EXPECT_TRUE(p.interrupt.read());
  const auto control = [&p](std::uint32_t bits) {
    p.host.write(reg::control, bits);
    sc_core::sc_start(sc_time(1, SC_NS));
    return p.interrupt.read();
  };
  EXPECT_FALSE(control(0)) << "not enabled";
  EXPECT_TRUE(control(control_interrupt_enable));
  EXPECT_FALSE(control(control_interrupt_enable | control_clear));
  EXPECT_EQ(p.host.read(reg::status), 0u);
}

TEST(TlmUnit, AStartWhileAFrameRunsIsIgnored) {
  Platform p;
  p.start();
  sc_core::sc_start(sc_time(500, SC_NS));
  p.host.write(reg::control, control_start | control_clear | control_interrupt_enable);
  EXPECT_EQ(p.host.read(reg::status), status_running);
  sc_core::sc_start();
  const std::uint64_t once = p.cycles();
  EXPECT_EQ(p.run(), status_done);
  EXPECT_EQ(p.cycles(), once);
}

std::uint32_t error(FrameError code) { return status_error | static_cast<std::uint32_t>(code) << status_code_shift; }

TEST(TlmUnit, ADescriptorThatCannotBeIsAnError) {
  const auto status_with = [](const std::function<void(Platform&, FrameDescriptor&)>& change) {
    Platform p;
    change(p, p.frame());
    const std::uint32_t status = p.run();
    EXPECT_TRUE(p.interrupt.read());
    EXPECT_TRUE(p.memory.addresses.empty());
    p.lay_down();
    p.tiny.descriptor = p.tiny.descriptor / 64 * 64 % window;
    p.memory.debug = true;
    return status;
  };
  const std::uint32_t wrong = error(FrameError::descriptor);
  EXPECT_EQ(status_with([](Platform& p, FrameDescriptor&) { p.tiny.descriptor += 4; }), wrong);
  EXPECT_EQ(status_with([](Platform& p, FrameDescriptor&) { p.tiny.descriptor = window - 64; }), wrong);
  EXPECT_EQ(status_with([](Platform& p, FrameDescriptor&) { p.memory.debug = false; }), wrong);
  EXPECT_EQ(status_with([](Platform&, FrameDescriptor& f) { f.width = 0; }), wrong);
  EXPECT_EQ(status_with([](Platform&, FrameDescriptor& f) { f.pitch = 20; }), wrong);
  EXPECT_EQ(status_with([](Platform&, FrameDescriptor& f) { f.height = 16385; }), wrong);
  EXPECT_EQ(status_with([](Platform&, FrameDescriptor& f) { f.frame_buffer += 4; }), wrong);
  EXPECT_EQ(status_with([](Platform&, FrameDescriptor& f) { f.frame_buffer = window - 64; }), wrong);
  EXPECT_EQ(status_with([](Platform&, FrameDescriptor& f) { f.lights = ~std::uint64_t{63}; }), wrong);
  EXPECT_EQ(status_with([](Platform&, FrameDescriptor& f) { f.light_count = 65; }), wrong);
}

TEST(TlmUnit, AfterAnErrorOfTheMemoryTheNextFrameIsFine) {
  Platform p;
  p.memory.status_of = [&p](const tlm::tlm_generic_payload&) {
    return p.memory.addresses.size() > 20 ? tlm::TLM_GENERIC_ERROR_RESPONSE : tlm::TLM_OK_RESPONSE;
  };
  EXPECT_EQ(p.run(), error(FrameError::memory_response));
  EXPECT_EQ(p.cycles(), 0u);
  EXPECT_EQ(p.memory.ended, p.memory.addresses.size()) << "nothing is left in the memory";
  p.memory.status_of = {};
  EXPECT_EQ(p.run(), status_done);
  Platform fresh;
  fresh.run();
  EXPECT_EQ(p.cycles(), fresh.cycles());
  EXPECT_EQ(tuples(p.records), tuples(fresh.records));
}

TEST(TlmUnit, ATreeThatPointsOutOfTheWindowIsAnError) {
  Platform p;
  p.frame().static_nodes = window + 4096;
  EXPECT_EQ(p.run(), error(FrameError::memory_address));
  p.lay_down();
  EXPECT_EQ(p.run(), status_done);
}

}  // namespace
}  // namespace artu::hw::test
