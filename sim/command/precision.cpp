#include <fmt/format.h>

#include <iterator>
#include <map>

#include "sim/command/commands.h"
#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/command/run_report.h"
#include "sim/config/configuration.h"
#include "sim/config/cross_check.h"
#include "sim/config/dump.h"
#include "sim/precision/plot.h"
#include "sim/precision/report.h"
#include "sim/precision/sweep.h"
#include "sim/report/file.h"
#include "sim/report/gnuplot.h"
#include "sim/report/heat.h"
#include "sim/report/names.h"
#include "sim/report/run_folder.h"

namespace artu::sim {
namespace {

/// One to two minutes for a frame of the sample stage on one core.
constexpr std::uint32_t default_bits[] = {7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 19, 21, 23};
constexpr const char* default_size = "320x180";

SourceOptions source_of(const PrecisionOptions& options) {
  require_file(options.source.path);
  SourceOptions source = options.source;
  if (!source.size && !traces::is_trace(source.path)) source.size = default_size;
  return source;
}

SweepPlan plan_of(const PrecisionOptions& options, const FrameRange& frames) {
  SweepPlan plan;
  plan.unit = Configuration::of(options.config_files, options.assignments).unit();
  plan.jobs = options.jobs;
  plan.trees = options.trees;
  if (plan.trees.empty()) plan.trees.assign(std::begin(all_trees), std::end(all_trees));
  for (const hw::TreeKind tree : plan.trees) {
    hw::UnitConfig unit = plan.unit;
    unit.accel.static_kind = unit.accel.dynamic_kind = tree;
    cross_check(unit, {});
  }
  plan.formats = options.formats;
  if (plan.formats.empty()) {
    for (const std::uint32_t m : default_bits) plan.formats.push_back({m, m, m});
  }
  plan.first_frame = frames.first;
  plan.last_frame = frames.last;
  return completed(plan);
}

/// Writes pictures as they come, and how far each is from those that came before: binary64, then 23 bits.
class FormatPictures {
 public:
  explicit FormatPictures(const RunFolder& folder) : folder_(folder) {}

  void write(const std::string& name, std::uint32_t index, const Image& image) {
    const auto file = [&](const std::string& what) { return folder_.file(fmt::format("{}_{:04}.png", what, index)); };
    write_png(file(file_name(name)), image);
    for (const auto& [reference, pictures] : references_) {
      const auto of_frame = pictures.find(index);
      if (of_frame == pictures.end() || reference == name) continue;
      write_png(file(file_name(name) + "-from-" + reference), heat_map(image, of_frame->second));
    }
    if (name == "binary64" || name == "M23") references_[name][index] = image;
  }

 private:
  const RunFolder& folder_;
  std::map<std::string, std::map<std::uint32_t, Image>> references_;
};

/// "" if all went well, else why there is no plot.
std::string draw(const RunFolder& folder, const std::vector<SweepRow>& rows, std::uint32_t frames,
                 const std::string& title) {
  const std::string script = plot_script(rows, frames, title);
  if (script.empty()) return "no picture differs from the two references, or they are too small for SSIM";
  return draw_plot(folder.partial(), {precision_plot, plot_data(rows, frames), script});
}

}  // namespace

int precision_command(const PrecisionOptions& options) {
  std::vector<std::string> log;
  const SourceOptions source_options = source_of(options);
  plan_of(options, {});  // refuses a bad configuration before anything slow begins
  RunFolder folder =
      options.output.empty() ? RunFolder::next_free(source_options.path) : RunFolder(options.output, options.force);
  const FrameSource source(source_options, log);
  const SweepPlan plan = plan_of(options, source.range());
  const std::uint32_t frames = source.range().count();

  FormatPictures pictures(folder);
  std::vector<SweepRow> rows;
  {
    Progress progress(sweep_steps(plan), "frames", options.quiet);
    SweepHooks hooks;
    hooks.frame = [&](std::uint32_t index) { return source.frame(index); };
    hooks.frame_from = [&](std::uint32_t index) { return source.first_from(index); };
    hooks.picture = [&](const std::string& name, std::uint32_t index, const Image& image) {
      pictures.write(name, index, image);
    };
    hooks.progress = [&] { progress.one_done(); };
    rows = run_sweep(source.scene(), plan, hooks);
  }
  const Manifest manifest = manifest_of(options.command, source_options.path, source);
  const std::string title = heading(source_options.path, source);
  write_file(folder.file("precision.csv"), format_csv(rows));
  write_file(folder.file("precision.json"), format_json(rows, plan, manifest));
  write_file(folder.file("config.toml"), dump_config(plan.unit));
  write_file(folder.file("manifest.json"), to_json(manifest));
  const std::string no_plot = draw(folder, rows, frames, title);
  folder.commit();

  if (!no_plot.empty()) log.push_back("no plot: " + no_plot);
  print_notes(log, options.quiet);
  if (!options.quiet) {
    fmt::print("{}\n\n{}\n{:<12}{}\n", title, format_table(rows, frames), "report", folder.name());
  }
  return exit_fine;
}

}  // namespace artu::sim
