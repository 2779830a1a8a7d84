#include "sim/sweep/slurm.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <thread>

#include "sim/report/durable.h"
#include "sim/report/file.h"
#include "sim/sweep/external.h"
#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

constexpr int submissions = 3;
constexpr auto between_looks = std::chrono::seconds(1);
constexpr int looks_without_answer = 60;

std::string own_program() { return fs::read_symlink("/proc/self/exe").string(); }

/// Its tasks know their part from the variable that Slurm sets.
std::string script_of(const SweepFolder& folder, const SlurmJob& job) {
  return fmt::format("#!/bin/sh\nexec {} sweep {} -o {} --part \"$SLURM_ARRAY_TASK_ID/{}\" --quiet\n",
                     shell_word(own_program()), shell_word(job.grid), shell_word(folder.name()), job.parts);
}

std::string submit(const SweepFolder& folder, const SlurmJob& job) {
  std::set<std::uint32_t> parts;
  for (const std::uint32_t number : job.numbers) parts.insert(number % job.parts);
  const std::string script = folder.file("slurm/task.sh");
  write_durably(script, script_of(folder, job));
  std::string array = fmt::format("--array={}", fmt::join(parts, ","));
  if (job.at_once != 0) array += fmt::format("%{}", job.at_once);
  const ProgramOutput result =
      run_program({"sbatch", "--parsable", array, "--requeue", "--job-name=artu-sweep", "--open-mode=append",
                   "--output=" + folder.file("slurm/part-%a.log"), script});
  if (result.code != 0) {
    throw InputError("--backend slurm",
                     fmt::format("sbatch {}; a machine that can submit jobs, or --backend local, would "
                                 "be right",
                                 result.err.empty() ? "failed" : result.err));
  }
  std::string id = result.out.substr(0, result.out.find_first_of(";\n"));
  write_durably(folder.file("slurm/job"), id + "\n");
  return id;
}

enum class State { waiting, gone, unknown };

State state_of(const std::string& id) {
  const ProgramOutput queue = run_program({"squeue", "--noheader", "--jobs=" + id, "--format=%T"});
  if (queue.code == 0) return queue.out.empty() ? State::gone : State::waiting;
  return queue.err.find("Invalid job id") != std::string::npos ? State::gone : State::unknown;
}

/// Until the job has ended or all points are finished.
void wait_for(const std::string& id, const SlurmJob& job) {
  for (int unanswered = 0; unanswered < looks_without_answer;) {
    const State state = state_of(id);
    // After the state: a task's last point is there before the task has ended.
    const std::uint64_t finished = job.finished();
    job.progress(finished);
    if (state == State::gone || finished == job.numbers.size()) return;
    unanswered = state == State::unknown ? unanswered + 1 : 0;
    std::this_thread::sleep_for(between_looks);
  }
  throw InputError(
      "--backend slurm",
      fmt::format("squeue has not answered for a minute; --resume when the controller is there, which waits "
                  "for job {}, would be right",
                  id));
}

}  // namespace

void run_on_slurm(const SweepFolder& folder, const SlurmJob& job) {
  if (job.numbers.empty()) return;
  std::error_code error;
  fs::create_directory(folder.file("slurm"), error);
  if (fs::exists(folder.file("slurm/job"), error)) {
    const std::string earlier = read_file(folder.file("slurm/job"));
    const std::string id = earlier.substr(0, earlier.find('\n'));
    if (!id.empty() && id.find_first_not_of("0123456789") == std::string::npos) wait_for(id, job);
  }
  for (int attempt = 0; attempt < submissions && job.finished() < job.numbers.size(); ++attempt) {
    wait_for(submit(folder, job), job);
  }
  const std::uint64_t finished = job.finished();
  if (finished < job.numbers.size()) {
    throw InputError(
        folder.file("slurm"),
        fmt::format("{} of {} points were not simulated in {} jobs; the logs there say why, and --resume goes "
                    "on",
                    job.numbers.size() - finished, job.numbers.size(), submissions));
  }
  fs::remove(folder.file("slurm/job"), error);
}

}  // namespace artu::sim
