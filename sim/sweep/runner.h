// Points in processes of their own, several at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace artu::sim {

struct PointWork {
  std::function<void(std::size_t)> prepare;  // in this process, before the point's is forked: what others can share
  std::function<void(std::size_t)> work;     // in the point's process
  std::function<void(std::size_t)> done;     // in this process, as each one ends
};

/// Points 0 ... count - 1 in their order, each in a process that is forked for it: what it leaves in memory goes with
/// it. What `work` throws is thrown here, as it happens, and the other processes are killed; so is a process that dies.
void run_points(std::size_t count, std::uint32_t jobs, const PointWork& points);

}  // namespace artu::sim
