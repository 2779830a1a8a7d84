#include "sim/command/run_report.h"

#include <fmt/format.h>

#include <set>

#include "sim/command/output_places.h"
#include "sim/config/dump.h"
#include "sim/report/pixel_csv.h"
#include "sim/report/stats_text.h"
#include "traces/error.h"

namespace artu::sim {

Manifest manifest_of(const std::vector<std::string>& command, const std::string& input, const FrameSource& source) {
  Manifest manifest;
  manifest.command = command;
  manifest.version = ARTU_VERSION;
  manifest.input = input;
  manifest.input_sha256 = source.sha256();
  manifest.input_is_trace = source.is_trace();
  manifest.first_frame = source.range().first;
  manifest.last_frame = source.range().last;
  manifest.width = source.scene().width;
  manifest.height = source.scene().height;
  manifest.fps = source.scene().fps;
  return manifest;
}

std::string heading(const std::string& input, const FrameSource& source) {
  const FrameRange range = source.range();
  return fmt::format(
      "{}, {}x{}, {}", input, source.scene().width, source.scene().height,
      range.count() == 1 ? fmt::format("frame {}", range.first) : fmt::format("frames {}:{}", range.first, range.last));
}

RunReport::RunReport(const RunOptions& options) : several_processes_(options.jobs > 1) {
  if (several_processes_ && !options.memory_trace.empty()) {
    throw InputError("--memory-trace", "is written in the order of the requests; without --jobs would be right");
  }
  if (several_processes_ && !options.trace.requests.empty()) {
    throw InputError("--trace", "is of one frame, which one process simulates; without --jobs would be right");
  }
  if (several_processes_ && !options.simulation.log.empty()) {
    throw InputError("--log", "the lines of several frames would mingle; without --jobs would be right");
  }
  check_output_places(options);
  if (!options.pixel_csv.empty()) {
    csv_ = std::make_unique<AtomicFile>(options.pixel_csv, options.force);
    csv_->write(pixel_csv_header);
  }
  if (!options.memory_trace.empty()) {
    memory_trace_ = std::make_unique<MemoryTrace>(options.memory_trace, options.memory_trace_format, options.force);
  }
  if (!options.output.empty()) {
    folder_.emplace(options.output, options.force);
  } else if (options.folder_by_default) {
    folder_.emplace(RunFolder::next_free(options.source.path));
  }
  if (options.pictures && !folder_) {
    throw InputError("--pictures", "there is no folder for them; -o DIR as well would be right");
  }
  if (options.simulation.timeline && !folder_) {
    throw InputError("--timeline", "there is no folder for it; -o DIR as well would be right");
  }
  const bool writes_files =
      !options.pixel_csv.empty() || !options.memory_trace.empty() || !options.trace.requests.empty();
  if (options.force && !folder_ && !writes_files) {
    throw InputError("--force", "there is nothing it could replace; -o DIR as well would be right");
  }
  set_ = options.pictures.value_or(PictureSet{Picture::frame, Picture::decision, Picture::hit_class});
  if (folder_) {
    json_ = std::make_unique<StatsJson>(folder_->file("stats.json"));
    if (options.simulation.timeline) timeline_ = std::make_unique<TimelineJson>(folder_->file("timeline.json"));
  }
  open_traces(options);
}

void RunReport::open_traces(const RunOptions& options) {
  std::set<TraceKind> in_folder;
  for (const TraceRequest& request : options.trace.requests) {
    std::string file = request.file, shown = request.file;
    if (file.empty()) {
      if (!folder_)
        throw InputError("--trace", fmt::format("there is no folder for it; {}=FILE, or -o DIR as well, would be right",
                                                trace_kind_name(request.kind)));
      if (!in_folder.insert(request.kind).second) {
        throw InputError("--trace", fmt::format("{0} is asked for twice; {0}=FILE for one of them would be right",
                                                trace_kind_name(request.kind)));
      }
      file = folder_->file(trace_file_name(request.kind));
      shown = folder_->name() + "/" + trace_file_name(request.kind);
    }
    traces_.add(request.kind, file, shown, options.force, options.source.path);
  }
}

void RunReport::begin_pictures(std::uint32_t frames, double fps) {
  if (folder_) pictures_.emplace(folder_->file(""), set_, frames, fps);
}

FrameReport RunReport::write(const FrameOutcome& outcome, const hw::UnitConfig& unit, const FullRender* full) {
  FrameReport frame;
  frame.index = outcome.index;
  frame.dram_clocks = outcome.cycles * unit.memory.dram.clock_mhz / unit.clock_mhz;
  frame.totals = totals_of(outcome);
  frame.violations = outcome.violations;
  if (csv_) {
    pixel_csv_rows(outcome, [&](const std::string& rows) {
      if (several_processes_) {
        frame.pixel_csv += rows;
      } else {
        csv_->write(rows);
      }
    });
  }
  if (folder_) frame.animation = pictures_->write(outcome, full);
  if (timeline_) frame.timeline = timeline_of(outcome);
  return frame;
}

void RunReport::add(const FrameReport& frame, const hw::UnitConfig& unit) {
  if (memory_trace_) memory_trace_->end_frame(frame.dram_clocks);
  if (csv_) csv_->write(frame.pixel_csv);
  if (!folder_) return;
  pictures_->append(frame.animation);
  if (timeline_) timeline_->add(frame.timeline);
  const auto energy = energy_if_known(frame.totals, unit);
  json_->add_frame(frame.index, frame.totals, frame.violations, energy ? &*energy : nullptr);
}

void RunReport::finish(const Totals& sum, const hw::UnitConfig& unit, const Manifest& manifest,
                       const CheckResult* check) {
  traces_.close();  // into the folder, if that is where they are
  if (folder_) {
    pictures_->finish();
    if (timeline_) timeline_->finish();
    const auto known = energy_if_known(sum, unit);
    const Energy* energy = known ? &*known : nullptr;
    json_->finish(sum, unit.clock_mhz, check, energy, demands_if_known(sum, unit));
    const double golden_seconds = check ? check->golden_seconds : -1;
    write_file(folder_->file("stats.txt"), format_stats(sum, unit.clock_mhz, golden_seconds, energy));
    write_file(folder_->file("config.toml"), dump_config(unit));
    write_file(folder_->file("manifest.json"), to_json(manifest));
    folder_->commit();
  }
  if (csv_) csv_->close();
  if (memory_trace_) memory_trace_->close();
}

}  // namespace artu::sim
