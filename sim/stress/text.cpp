#include <fmt/format.h>

#include "sim/stress/report.h"

namespace artu::sim {
namespace {

std::string quantiles(const Distribution& d) {
  if (d.count() == 0) return fmt::format("{:>6} {:>7} {:>9}", "-", "-", "-");
  return fmt::format("{:>6.2f} {:>7.2f} {:>9.3g}", d.quantile(0.5), d.quantile(0.99), d.quantile(1));
}

std::string of(const Count& count) {
  return count.tried == 0 ? "-" : fmt::format("{}/{}", count.happened, count.tried);
}

std::string header(const char* first, const CaseResult& any) {
  std::string text = fmt::format("{:<24}{:>10}{:>10}{:>9}", first, "rays", "hits", "brute");
  for (const Tally& tally : any.tallies) text += fmt::format("{:>7}", tally.name);
  return text + fmt::format("{:>15}{:>17}{:>16}{:>13}  {:>6} {:>7} {:>9}\n", "leaks", "self out", "self in", "convex",
                            "t p50", "p99", "max ulp");
}

std::string row(const std::string& name, const CaseResult& r) {
  const std::uint64_t brute = r.tallies.empty() ? 0 : r.tallies[0].compared;
  std::string text = fmt::format("{:<24}{:>10}{:>10}{:>9}", name, r.rays, r.hits, brute);
  for (const Tally& tally : r.tallies) text += fmt::format("{:>7}", tally.mismatches);
  return text + fmt::format("{:>15}{:>17}{:>16}{:>13}  {}\n", of(r.leaks), of(r.self_out), of(r.self_in), of(r.convex),
                            quantiles(r.accuracy.t_ulps));
}

std::string accuracy_row(const std::string& name, const Accuracy& a) {
  return fmt::format("{:<14}{:>9}  {}  {}  {}  {:>16} {:>10}\n", name, a.t_ulps.count(), quantiles(a.t_ulps),
                     quantiles(a.u), quantiles(a.v), of(a.decisions), a.explained);
}

std::string vector_text(hw::Vector v) {
  return fmt::format("{{{:#010x}, {:#010x}, {:#010x}}}  ({:.9g}, {:.9g}, {:.9g})", hw::bits_of(v.x), hw::bits_of(v.y),
                     hw::bits_of(v.z), v.x, v.y, v.z);
}

std::string answer_text(const Answer& answer) {
  if (!answer.hit) return "no hit";
  return fmt::format("triangle {}, t {:#010x} ({:.9g}), U {:#010x}, V {:#010x}, det {:#010x}", answer.primitive,
                     hw::bits_of(answer.at.t), answer.at.t, hw::bits_of(answer.at.U), hw::bits_of(answer.at.V),
                     hw::bits_of(answer.at.det));
}

std::string triangle_text(const char* name, const std::optional<Corners>& triangle) {
  if (!triangle) return "";
  std::string text;
  for (int i = 0; i < 3; ++i) text += fmt::format("  {:<10}{}\n", i == 0 ? name : "", vector_text((*triangle)[i]));
  return text;
}

}  // namespace

std::string format_failure(const Failure& f) {
  std::string text = fmt::format("{}: case {}, ray {} ({})\n", f.what, f.case_name, f.index, f.ray_kind);
  text += fmt::format("  {:<10}{}\n  {:<10}{}\n", "origin", vector_text(f.ray.origin), "direction",
                      vector_text(f.ray.direction));
  text += fmt::format("  {:<10}{:#010x} ({:.9g})\n", "tmax", hw::bits_of(f.ray.tmax), f.ray.tmax);
  text += fmt::format("  {:<10}{}\n", "expected", answer_text(f.expected)) + triangle_text("", f.expected_triangle);
  text += fmt::format("  {:<10}{}\n", "found", answer_text(f.found)) + triangle_text("", f.found_triangle);
  if (f.occlusion) text += fmt::format("  {:<10}{}\n", "any hit", f.found_occluded ? "found one" : "found none");
  return text;
}

namespace {

std::string accuracy_header(const char* first) {
  return fmt::format("\n{:<14}{:>9}  {:^24}  {:^24}  {:^24}  {:>16} {:>10}\n", first, "hits", "t (ulp)", "u (2^-(M+1))",
                     "v (2^-(M+1))", "wrong decisions", "explained");
}

std::string format_name(const hw::PrecisionConfig& precision) {
  return precision.box == precision.triangle ? fmt::format("M {}", precision.box)
                                             : fmt::format("M {}/{}", precision.box, precision.triangle);
}

std::string case_table(const StressReport& report) {
  std::string text;
  if (!report.cases.empty()) text += header("case", report.cases[0]);
  for (const CaseResult& one : report.cases) text += row(one.name.name(), one);
  for (const std::string& name : report.skipped)
    text += fmt::format("{:<24}skipped: its model is not installed\n", name);
  const std::vector<CaseResult> rows = by_placement(report);
  if (rows.size() > 1) {
    text += "\nBy placement, all meshes\n" + header("case", rows[0]);
    for (const CaseResult& one : rows) text += row(one.name.placement.name, one);
  }
  if (report.options.leaks_only) return text;
  text += accuracy_header("accuracy");
  for (const CaseResult& one : rows) text += accuracy_row(one.name.placement.name, one.accuracy);
  for (const CaseResult& one : by_mesh(report)) text += accuracy_row(one.name.mesh, one.accuracy);
  return text;
}

/// Widths are box/triangle where they differ.
std::string format_comparison(const StressReports& reports) {
  std::string text;
  std::vector<CaseResult> sums;
  for (const StressReport& report : reports) sums.push_back(sum_of(report));
  text += header("format", sums[0]);
  for (std::size_t i = 0; i < sums.size(); ++i) text += row(format_name(reports[i].options.precision), sums[i]);
  if (reports[0].options.leaks_only) return text;
  text += accuracy_header("accuracy");
  for (std::size_t i = 0; i < sums.size(); ++i) {
    text += accuracy_row(format_name(reports[i].options.precision), sums[i].accuracy);
  }
  return text;
}

}  // namespace

std::string format_table(const StressReports& reports) {
  std::string text = reports.size() == 1 ? case_table(reports[0]) : format_comparison(reports);
  const StressTotals totals = totals_of(reports);
  text += "\n";
  if (totals.first != nullptr) text += format_failure(*totals.first);
  text +=
      fmt::format("{} cases, {} rays and {} secondary rays, {} hits, seed {}: {} mismatches, {} leaks\n", totals.cases,
                  totals.rays, totals.secondary, totals.hits, reports[0].options.seed, totals.mismatches, totals.leaks);
  return text;
}

std::string format_case_list() {
  std::string text = "Meshes\n";
  for (const MeshEntry& mesh : mesh_entries()) text += fmt::format("  {:<14}{}\n", mesh.name, mesh.what);
  text += "Placements\n";
  for (const Placement& p : placements()) {
    text += fmt::format("  {:<14}position * {:g} + {:g}\n", p.name, p.scale, p.offset);
  }
  return text + "A case is MESH/PLACEMENT, or MESH for all its placements.\n";
}

}  // namespace artu::sim
