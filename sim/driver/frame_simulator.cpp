#include "sim/driver/frame_simulator.h"

#include <stdexcept>

#include "sim/analytic/analytic_simulator.h"
#include "sim/driver/functional_simulator.h"
#include "sim/driver/simulator.h"
#include "traces/error.h"

namespace artu::sim {

void check_options(const SimulationOptions& options) {
  if (is_exact(options.fidelity)) return;
  const std::string mode = fidelity_name(options.fidelity);
  const auto refuse = [&mode](bool given, const char* option, const char* what) {
    if (!given) return;
    throw InputError(option, std::string(what) + ", which --fidelity " + mode + " does not have; event would be right");
  };
  refuse(options.random_stall, "--random-stall", "is about channels");
  refuse(options.shuffle_ticks, "--shuffle", "is about cycles");
  refuse(!options.log.empty(), "--log", "is about blocks");
  refuse(options.timeline, "--timeline", "is about cycles");
  refuse(bool{options.memory_observer}, "--memory-trace", "is about requests in their order");
  refuse(!options.watchers.empty(), "--trace", "is about cycles");
  refuse(options.fault.datapath != hw::Datapath::none, "--inject-fault", "is about blocks");
}

std::unique_ptr<FrameSimulator> make_simulator(const traces::Scene& scene, const hw::UnitConfig& unit,
                                               const SimulationOptions& options, FrameFrom frames) {
  check_options(options);
  if (is_exact(options.fidelity)) return std::make_unique<Simulator>(scene, unit, options, std::move(frames));
  if (options.fidelity == Fidelity::functional) {
    return std::make_unique<FunctionalSimulator>(scene, unit, options, std::move(frames));
  }
  if (options.fidelity == Fidelity::analytic) {
    return std::make_unique<AnalyticSimulator>(scene, unit, options, std::move(frames));
  }
  throw std::logic_error("sampled is about several frames: no mode of one");
}

}  // namespace artu::sim
