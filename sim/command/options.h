// What the command line asks for, as the commands take it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/driver/frame_simulator.h"
#include "sim/report/memory_trace.h"
#include "sim/report/picture_set.h"
#include "sim/sampled/sequence.h"
#include "sim/viewers/trace_set.h"

namespace artu::sim {

struct SourceOptions {
  std::string path;                   // scene or trace
  std::optional<std::string> frames;  // A:B, A or all
  std::optional<std::string> size;    // WxH
  std::optional<double> fps;
};

struct RunOptions {
  SourceOptions source;
  std::vector<std::string> config_files, assignments;
  SimulationOptions simulation;
  SampleSize sample;         // of the frames, where the fidelity is `sampled`
  std::string sample_given;  // the option that has set it; "" = none given
  bool seed_given = false;
  bool check = false;
  bool folder_by_default = true;                // without `output`: a folder in runs/, or none
  std::string output, pixel_csv, memory_trace;  // "" = none given
  MemoryTraceFormat memory_trace_format = MemoryTraceFormat::dramsim3;
  TraceOptions trace;                  // for viewers
  std::optional<PictureSet> pictures;  // of the report; none given: frame, decision, class
  bool dump_config = false, list_params = false, list_stats = false;
  std::uint32_t jobs = 1;  // processes
  bool dry_run = false, force = false, quiet = false;
  std::vector<std::string> command;  // the words of the command line
};

struct PrecisionOptions {
  SourceOptions source;  // a scene without a size is 320x180
  std::vector<std::string> config_files, assignments;
  std::vector<hw::PrecisionConfig> formats;  // none: those of `precision_command`
  std::vector<hw::TreeKind> trees;           // none: all
  std::string output;                        // "" = none given
  std::uint32_t jobs = 1;                    // processes
  bool force = false, quiet = false;
  std::vector<std::string> command;  // the words of the command line
};

struct ScalingOptions {
  SourceOptions source;
  std::vector<std::string> config_files, assignments;
  std::string variation;  // PARAMETER=VALUE,VALUE...
  Fidelity fidelity = Fidelity::event;
  std::string output;      // "" = none given
  std::uint32_t jobs = 1;  // processes
  bool force = false, quiet = false;
  std::vector<std::string> command;  // the words of the command line
};

struct ReuseOptions {
  SourceOptions source;
  std::vector<std::string> config_files, assignments;
  std::uint32_t jobs = 1;        // processes
  std::uint64_t window = 10000;  // cycles, of the working set
  std::string output;            // "" = none given
  bool force = false, quiet = false;
  std::vector<std::string> command;  // the words of the command line
};

struct ExplainOptions {
  SourceOptions source;  // `path` may be a run's folder
  std::vector<std::string> config_files, assignments;
  std::uint32_t jobs = 1;  // processes
  bool verify = false, json = false, quiet = false;
};

struct SweepOptions {
  std::string grid;    // GRID.toml
  std::string output;  // "" = none given
  // Points at the same time; none given: 1, on a cluster as many as there is room for.
  std::optional<std::uint32_t> jobs;
  std::string part;    // K/T; "" = all
  bool slurm = false;  // the points as jobs of a cluster
  bool resume = false, collect = false, dry_run = false, force = false, quiet = false;
};

struct SamplingOptions {
  SourceOptions source;
  std::vector<std::string> config_files, assignments;
  SampleSize sample;
  std::uint32_t trials = 200;
  std::uint64_t seed = 1;  // of the first trial
  std::uint32_t jobs = 1;
  bool quiet = false;
};

struct QualityOptions {
  SourceOptions source;
  std::vector<std::string> config_files, assignments;
  std::string references = "0,2,4,8,16,32,64";  // thresholds, 0 ... 255
  std::string policies;                         // "" = all
  std::string shares = "30,40,50";              // traced, in percent
  std::uint32_t worst = 20;                     // pixels of each point in worst_pixels.csv
  PictureSet pictures{Picture::strip};
  std::string output;      // "" = none given
  std::uint32_t jobs = 1;  // processes
  bool force = false, quiet = false;
  std::vector<std::string> command;  // the words of the command line
};

struct BenchOptions {
  std::vector<std::string> scenes;     // files and folders; none: the samples
  std::optional<std::uint32_t> frame;  // none: the first
  std::string size = "320x180";        // of scenes; a trace has its own
  std::string fidelity;                // names between commas; "" = all
  std::uint32_t repeats = 5;
  std::uint64_t seed = 1;
  bool growth = true;
  std::vector<std::string> config_files, assignments;
  std::string output;  // "" = none given
  bool force = false, quiet = false;
  std::vector<std::string> command;  // the words of the command line
};

struct ReportOptions {
  std::vector<std::string> folders;
  std::string output;                    // "" = report.html in the first folder
  std::uint32_t picture_megabytes = 64;  // of PNG files
  bool force = false, quiet = false;
};

struct ImportOptionsOfCommand {
  SourceOptions source;
  std::string output;
  bool force = false, quiet = false;
};

}  // namespace artu::sim
