// The memory trace: what DRAM simulators read, line by line, and what the DRAM counted.
#include "sim/report/memory_trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "traces/error.h"
#include "unit/sim/temp_folder.h"

namespace artu::sim {
namespace {

namespace fs = std::filesystem;

const hw::MemoryRequest read{0x12340, 0, 7, 1}, write{0xffffffffc0, 1, 7, 1};

TEST(MemoryTrace, LinesAreThoseOfTheReaders) {
  EXPECT_EQ(memory_trace_line(MemoryTraceFormat::dramsim3, 41, read), "0x12340 READ 41\n");
  EXPECT_EQ(memory_trace_line(MemoryTraceFormat::dramsim3, 41, write), "0xffffffffc0 WRITE 41\n");
  EXPECT_EQ(memory_trace_line(MemoryTraceFormat::ramulator, 41, read), "0x12340 R\n");
  EXPECT_EQ(memory_trace_line(MemoryTraceFormat::ramulator, 41, write), "0xffffffffc0 W\n");
  EXPECT_EQ(memory_trace_line(MemoryTraceFormat::ramulator2, 41, read), "LD 0x12340\n");
  EXPECT_EQ(memory_trace_line(MemoryTraceFormat::ramulator2, 41, write), "ST 0xffffffffc0\n");
}

TEST(MemoryTrace, AFrameBeginsWhereTheOneBeforeEnds) {
  const test::TempFolder folder;
  const std::string name = folder.path("frames.trace");
  {
    MemoryTrace trace(name, MemoryTraceFormat::dramsim3, false);
    const hw::MemoryObserver observer = trace.observer();
    observer(3, read);
    observer(100, write);
    trace.end_frame(100);
    observer(1, read);
    trace.end_frame(50);
    observer(1, read);
    EXPECT_FALSE(fs::exists(name)) << "not before it is whole";
    trace.close();
  }
  EXPECT_EQ(read_file(name), "0x12340 READ 3\n0xffffffffc0 WRITE 100\n0x12340 READ 101\n0x12340 READ 151\n");
}

TEST(MemoryTrace, AFullDiskIsReportedAtTheEndOfTheFrame) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  const test::TempFolder folder;
  const std::string name = folder.path("full.trace");
  fs::create_symlink("/dev/full", name + ".partial");
  {
    MemoryTrace trace(name, MemoryTraceFormat::dramsim3, false);
    const hw::MemoryObserver observer = trace.observer();
    for (hw::Cycle cycle = 1; cycle < 100000; ++cycle) EXPECT_NO_THROW(observer(cycle, read));
    EXPECT_THROW(trace.end_frame(100000), InputError);
  }
  EXPECT_FALSE(fs::exists(name));
  EXPECT_FALSE(fs::is_symlink(name + ".partial"));
}

}  // namespace
}  // namespace artu::sim
