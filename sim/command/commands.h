// The commands.  Each returns the exit code; bad input throws InputError, a dead-lock DeadLock.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/command/options.h"
#include "sim/stress/stress.h"

namespace artu::sim {

enum ExitCode { exit_fine = 0, exit_mismatch = 1, exit_input = 2, exit_dead_lock = 3, exit_internal = 4 };

struct StressCommandOptions {
  StressOptions stress;
  std::vector<hw::PrecisionConfig> formats{{}};
  std::string json;  // "" = none given
  bool list = false, force = false, quiet = false;
};

struct TortureOptions {
  std::uint64_t cases = 200, seed = 1;
  std::uint32_t jobs = 1;  // processes
  std::string output;      // of the smallest case that fails; "" = none given
  hw::Fault fault;
  bool dry_run = false, quiet = false;
};

int run_command(const RunOptions& options);
int import_command(const ImportOptionsOfCommand& options);
int sweep_command(const SweepOptions& options);
int scaling_command(const ScalingOptions& options);
int quality_command(const QualityOptions& options);
int precision_command(const PrecisionOptions& options);
int explain_command(const ExplainOptions& options);
int reuse_command(const ReuseOptions& options);
int bench_command(const BenchOptions& options);
int sampling_command(const SamplingOptions& options);
int report_command(const ReportOptions& options);
int diff_command(const std::string& a, const std::string& b);
int stress_command(const StressCommandOptions& options);
int torture_command(const TortureOptions& options);

/// Parses the command line and runs what it asks for.
int main_command(int argc, const char* const* argv);

/// Turns an exception into one line on stderr and its exit code.
int exit_code_of(const std::function<int()>& command);

/// The importer's notes, on stderr.  Only after success, so that an error is the one line there is.
void print_notes(const std::vector<std::string>& notes, bool quiet);

}  // namespace artu::sim
