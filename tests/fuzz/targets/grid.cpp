// Grids of `artu sweep`, through to their points and to sweep.json.
#include <string>

#include "fuzz/harness.h"
#include "sim/sweep/grid.h"
#include "sim/sweep/plan.h"

namespace {

/// Large ones are no other code, only more time.
bool is_small(const artu::sim::Grid& grid) {
  std::size_t points = grid.axes.size() <= 64 ? 1 : 1'000;
  for (const auto& axis : grid.axes) {
    if (grid.design == artu::sim::Design::grid && points < 1'000) points *= axis.values.size();
  }
  return points * grid.scenes.size() <= 256 && grid.samples <= 256 && grid.listed.size() <= 256;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artu;
  static fuzz::Sandbox sandbox;
  sandbox.furnish();
  sandbox.write("unit.toml", "[core]\ncount = 2\n");
  const std::string file = sandbox.write("grid.toml", data, size);
  fuzz::read_or_refuse([&] {
    sim::Grid grid = sim::read_grid(file);
    if (!is_small(grid)) return;
    const sim::SweepPoints plan = sim::plan_of(std::move(grid));
    for (const sim::SweepPoint& point : plan.points) {
      fuzz::require(point.values.size() == plan.grid.axes.size(), "a value of every axis");
      fuzz::require(!sim::run_of(plan.grid, point).command.empty(), "a command of every point");
    }
    fuzz::require(!sim::to_json(plan).empty(), "a description");
  });
  return 0;
}
