// Points as a job array of Slurm: https://slurm.schedmd.com/job_array.html.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/sweep/sweep_folder.h"

namespace artu::sim {

struct SlurmJob {
  std::string grid;                             // GRID.toml, from the working directory
  std::uint32_t parts = 1;                      // of --part K/parts
  std::uint32_t at_once = 0;                    // tasks that run at the same time; 0: as many as there is room for
  std::vector<std::uint32_t> numbers;           // of the points that are pending
  std::function<std::uint64_t()> finished;      // how many of them are not any more
  std::function<void(std::uint64_t)> progress;  // told of them as time passes
};

/// Parts of an array, at most: Slurm's default for MaxArraySize is 1001.
constexpr std::uint32_t maximum_parts = 1000;

/// Submits the parts that have pending points and waits until these are finished.  Slurm puts tasks of a lost node back
/// into the queue; points that no task has finished when the job has ended are submitted again, three times in all.  A
/// job of an earlier process, which was killed, is waited for first.  Throws InputError where there is no Slurm, where
/// it refuses the job, and where points stay pending.
void run_on_slurm(const SweepFolder& folder, const SlurmJob& job);

}  // namespace artu::sim
