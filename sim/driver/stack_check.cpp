#include "sim/driver/stack_check.h"

#include "hw/ray_core/ray_stack.h"
#include "traces/error.h"

namespace artu::sim {

void check_stack(const std::string& scene, std::uint32_t frame, std::uint32_t needed, const hw::RayCoreConfig& core) {
  const bool refuse = core.stack_overflow == hw::StackOverflow::refuse;
  const std::uint32_t room = refuse ? core.stack_entries : hw::maximum_stack;
  if (needed <= room) return;
  throw InputError(
      scene + ": frame " + std::to_string(frame),
      "the tree needs a stack of " + std::to_string(needed) + " entries; " +
          (refuse ? "core.stack_entries is " : "no more can be spilled or found again than ") + std::to_string(room) +
          (refuse && needed <= hw::maximum_stack ? "; with core.stack_overflow = spill fewer are enough" : ""));
}

}  // namespace artu::sim
