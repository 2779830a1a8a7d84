// What the host's memory is said to be.
#include "sim/report/memory_use.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "hw/memory/image.h"

namespace artu::sim {
namespace {

constexpr std::uint64_t megabyte = 1 << 20;

/// Of pages that were touched.
std::unique_ptr<char[]> block(std::size_t bytes) {
  std::unique_ptr<char[]> memory(new char[bytes]);
  std::memset(memory.get(), 1, bytes);
  return memory;
}

TEST(MemoryUse, PartsOfARunAreToldApart) {
  if (resident_bytes() == 0) GTEST_SKIP() << "the system does not tell";
  MemoryMeter meter;
  auto scene = block(40 * megabyte);
  block(20 * megabyte);  // for a while
  meter.loaded();
  const std::uint64_t before = meter.use().frames;
  auto frame = block(30 * megabyte);
  frame.reset();
  const MemoryUse use = meter.use();
  EXPECT_GE(use.loading, 59 * megabyte);
  EXPECT_LT(use.loading, 70 * megabyte);
  EXPECT_LT(before, 5 * megabyte);
  EXPECT_GE(use.frames, 29 * megabyte);
  EXPECT_LT(use.frames, 40 * megabyte);
  EXPECT_GE(use.peak, use.loading);
}

TEST(MemoryUse, OfSeveralTheLargest) {
  MemoryUse sum{5, 3, 1};
  sum.keep_larger({4, 9, 2});
  EXPECT_EQ(sum.peak, 5u);
  EXPECT_EQ(sum.loading, 9u);
  EXPECT_EQ(sum.frames, 2u);
}

TEST(MemoryImage, GrowsWithoutLosingAByte) {
  hw::MemoryImage image;
  std::vector<hw::Address> places;
  for (std::uint32_t i = 0; i < 2000; ++i) {  // some megabytes, over the size from which malloc maps pages
    places.push_back(image.allocate(64 * (1 + i % 70)));
    EXPECT_EQ(places.back() % 64, 0u);
    EXPECT_EQ(image.at<std::uint32_t>(places.back()), 0u);
    image.at<std::uint32_t>(places.back()) = i;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&image.at<char>(places.back())) % 64, 0u);
  }
  const hw::MemoryImage copy = image;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    ASSERT_EQ(image.at<std::uint32_t>(places[i]), i);
    ASSERT_EQ(copy.at<std::uint32_t>(places[i]), i);
  }
  image.shrink(places[100]);
  EXPECT_EQ(image.allocate(64), places[100]);
  EXPECT_EQ(image.at<std::uint32_t>(places[100]), 0u) << "is zeroed again";
  EXPECT_EQ(copy.at<std::uint32_t>(places[100]), 100u);
}

}  // namespace
}  // namespace artu::sim
