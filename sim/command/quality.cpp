#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "sim/command/commands.h"
#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/command/run_report.h"
#include "sim/config/configuration.h"
#include "sim/config/dump.h"
#include "sim/quality/policies.h"
#include "sim/quality/report.h"
#include "sim/report/file.h"
#include "sim/report/run_folder.h"

namespace artu::sim {
namespace {

hw::UnitConfig unit_with(const QualityOptions& options, const std::vector<std::string>& more) {
  std::vector<std::string> assignments = options.assignments;
  assignments.insert(assignments.end(), more.begin(), more.end());
  return Configuration::of(options.config_files, assignments).unit();
}

/// Of each policy, the point whose reference is nearest to the configuration's is shown.
QualityPlan plan_of(const QualityOptions& options) {
  QualityPlan plan;
  plan.worst = options.worst;
  plan.jobs = options.jobs;
  plan.full = unit_with(options, {"selective.enabled=false"});
  const auto distance = [&](const QualityPoint& p) {
    return std::abs(std::int64_t{p.reference} - std::int64_t{plan.full.selective.reference});
  };
  for (const Policy& policy : options.policies.empty() ? all_policies() : parse_policies(options.policies)) {
    std::vector<std::string> more = policy.assignments;
    more.push_back("selective.enabled=true");
    std::size_t nearest = plan.points.size();
    for (const std::uint32_t reference : parse_references(options.references)) {
      std::vector<std::string> all = more;
      all.push_back(fmt::format("selective.reference={}", reference));
      plan.points.push_back({policy.name, reference, unit_with(options, all)});
      if (distance(plan.points.back()) < distance(plan.points[nearest])) nearest = plan.points.size() - 1;
    }
    plan.points[nearest].shown = true;
  }
  return plan;
}

/// Pictures of the points that are shown, named after them: attention-16_strip_0000.png.
class PointPictures {
 public:
  PointPictures(const RunFolder& folder, const PictureSet& set, std::uint32_t frames, double fps)
      : folder_(folder), set_(set), frames_(frames), fps_(fps) {}

  void begin(const std::string& row) { writers_.try_emplace(row, folder_.file(row + "_"), set_, frames_, fps_); }
  PictureWriter& of(const QualityRow& row) { return writers_.at(row.name()); }
  void finish() {
    for (auto& [name, writer] : writers_) writer.finish();
  }

 private:
  const RunFolder& folder_;
  const PictureSet set_;
  const std::uint32_t frames_;
  const double fps_;
  std::map<std::string, PictureWriter> writers_;
};

}  // namespace

int quality_command(const QualityOptions& options) {
  std::vector<std::string> log;
  require_file(options.source.path);
  QualityPlan plan = plan_of(options);
  const std::vector<double> shares = parse_shares(options.shares);
  RunFolder folder =
      options.output.empty() ? RunFolder::next_free(options.source.path) : RunFolder(options.output, options.force);
  const FrameSource source(options.source, log);
  plan.first_frame = source.range().first;
  plan.last_frame = source.range().last;

  PointPictures pictures(folder, options.pictures, plan.frames(), source.scene().fps);
  for (const QualityPoint& point : plan.points) {
    if (point.shown) pictures.begin(fmt::format("{}-{}", point.policy, point.reference));
  }
  std::vector<QualityRow> rows;
  {
    Progress progress(plan.steps(), "frames", options.quiet);
    QualityHooks hooks;
    hooks.frame = [&](std::uint32_t index) { return source.frame(index); };
    hooks.frame_from = [&](std::uint32_t index) { return source.first_from(index); };
    hooks.picture = [&](const QualityRow& row, const FrameOutcome& outcome, const FullRender& full) {
      return pictures.of(row).write(outcome, &full);
    };
    hooks.part = [&](const QualityRow& row, const std::string& part) { pictures.of(row).append(part); };
    hooks.progress = [&] { progress.one_done(); };
    rows = run_quality(source.scene(), plan, hooks);
  }
  pictures.finish();

  const Manifest manifest = manifest_of(options.command, options.source.path, source);
  const std::string title = heading(options.source.path, source);
  const std::string tables = fmt::format("{}\n\n{}\n{}\n{}", title, format_quality(rows, plan.frames()),
                                         format_equal_shares(rows, shares), format_attribution(rows));
  write_file(folder.file("quality.txt"), tables);
  write_file(folder.file("quality.csv"), quality_csv(rows));
  write_file(folder.file("equal_shares.csv"), equal_shares_csv(rows, shares));
  write_file(folder.file("attribution.csv"), attribution_csv(rows));
  write_file(folder.file("worst_pixels.csv"), worst_pixels_csv(rows));
  write_file(folder.file("quality.json"), quality_json(rows, shares, plan, manifest));
  write_file(folder.file("config.toml"), dump_config(unit_with(options, {})));
  write_file(folder.file("manifest.json"), to_json(manifest));
  const std::string no_plot = draw_plot(folder.partial(), quality_plot(rows, plan.frames(), title));
  folder.commit();

  if (!no_plot.empty()) log.push_back("no plot: " + no_plot);
  print_notes(log, options.quiet);
  if (!options.quiet) fmt::print("{}\n{:<12}{}\n", tables, "report", folder.name());
  return exit_fine;
}

}  // namespace artu::sim
