// The accounting laws see what does not add up: a count that is too large as well as one that is too small.
#include <gtest/gtest.h>

#include "hw/memory/dram.h"
#include "unit/hw/tiny_frame.h"

namespace artu::hw::test {
namespace {

using Strings = std::vector<std::string>;

/// A DRAM that misreports what it has read by so many bytes.
class Misreporting : public Dram {
 public:
  Misreporting(ClockDomain& domain, const DramConfig& config, std::int64_t by)
      : Dram("dram", domain, config), by_(by) {}
  std::uint64_t read_bytes() const override { return Dram::read_bytes() + static_cast<std::uint64_t>(by_); }

 private:
  const std::int64_t by_;
};

Strings violations_with(std::int64_t misreported, std::uint8_t written) {
  const UnitConfig config = TinyUnit::small();
  SimulationContext context;
  context.enter();
  TinyFrame tiny(21, 13);
  PixelRecords records(21 * 13);
  for (PixelRecord& record : records) record.written = written;
  RayTracingUnit unit("unit", config, {}, tiny.image, {}, [&](ClockDomain& domain) -> std::unique_ptr<MainMemory> {
    return std::make_unique<Misreporting>(domain, config.memory.dram, misreported);
  });
  return unit.run(tiny.descriptor, &records).violations;
}

TEST(Laws, HoldForAFrame) { EXPECT_THAT(violations_with(0, 0), testing::IsEmpty()); }

TEST(Laws, ACountIsSeenThatIsTooLargeOrTooSmall) {
  for (const std::int64_t by : {-64, 64}) {
    EXPECT_THAT(violations_with(by, 0),
                testing::ElementsAre(testing::AllOf(testing::StartsWith("bytes read from DRAM ("),
                                                    testing::HasSubstr("!= lines filled into the L2, in bytes ("))))
        << by;
  }
}

TEST(Laws, APixelThatIsWrittenTwiceIsSeen) {
  EXPECT_THAT(violations_with(0, 1), testing::ElementsAre("pixels written exactly once (0) != pixels (273)"));
}

}  // namespace
}  // namespace artu::hw::test
