#include "hw/fabric/simulation_context.h"

#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

sc_core::sc_simcontext* current() { return sc_core::sc_curr_simcontext; }

TEST(SimulationContext, IsCurrentFromItsBeginningAndGivesBackAtItsEnd) {
  SimulationContext outer;
  sc_core::sc_simcontext* const of_outer = current();
  {
    SimulationContext inner;
    EXPECT_NE(current(), of_outer);
    EXPECT_EQ(current(), sc_core::sc_default_global_context);
  }
  EXPECT_EQ(current(), of_outer);
  EXPECT_EQ(sc_core::sc_default_global_context, of_outer);
}

TEST(SimulationContext, NoneThatHasEndedComesBack) {
  auto first = std::make_unique<SimulationContext>();
  sc_core::sc_simcontext* const of_first = current();
  SimulationContext second;
  sc_core::sc_simcontext* const of_second = current();
  first.reset();
  EXPECT_EQ(current(), of_second);
  { SimulationContext third; }
  EXPECT_EQ(current(), of_second);
  EXPECT_NE(current(), of_first);
}

TEST(SimulationContext, BenchesSideBySideRunEachItsOwn) {
  auto one = std::make_unique<Bench>();
  Bench other;
  one->run(10);
  other.run(20);
  EXPECT_EQ(one->timeline.now, 10 * one->clock.period());
  one.reset();
  other.run(30);
  EXPECT_EQ(other.timeline.now, 30 * other.clock.period());
}

}  // namespace
}  // namespace artu::hw::test
