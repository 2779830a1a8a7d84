// Tasks that are worked through by several processes, their results taken in the order of the tasks.
//
// Processes and not threads: SystemC has one context a process.  The workers are forked, so they have all that was
// loaded and built before, and share its memory while nobody writes to it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sim/jobs/archive.h"

namespace artu::sim {

inline constexpr std::uint32_t maximum_jobs = 256;

/// Each of the tasks 0 ... count - 1 goes to a process that is free; `take` gets what `work` returned, in this process.
/// What `work` throws is thrown here, after the results of the tasks before it were taken, as it would be with one
/// process.  Throws InputError where a worker was killed as when memory runs out, std::runtime_error where it ended in
/// another way.  No worker outlives the call, nor the program.
void run_in_processes(std::uint64_t count, std::uint32_t jobs, const std::function<std::string(std::uint64_t)>& work,
                      const std::function<void(std::uint64_t, const std::string&)>& take);

/// The same with values; with one job, or one task, in this process.
template <class Result, class Work, class Take>
void in_order(std::uint64_t count, std::uint32_t jobs, Work work, Take take) {
  if (jobs <= 1 || count <= 1) {
    for (std::uint64_t task = 0; task < count; ++task) take(task, work(task));
    return;
  }
  run_in_processes(
      count, jobs, [&](std::uint64_t task) { return to_bytes<Result>(work(task)); },
      [&](std::uint64_t task, const std::string& bytes) { take(task, from_bytes<Result>(bytes)); });
}

}  // namespace artu::sim
