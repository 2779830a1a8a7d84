#include <fmt/format.h>

#include <cmath>

#include "sim/precision/report.h"
#include "sim/report/names.h"

namespace artu::sim {
namespace {

using Cells = std::vector<std::string>;

std::string line(const Cells& cells) {
  static constexpr int widths[] = {5, 9, 7, 8, 7, 8, 8, 7, 9, 7, 9, 8, 7, 9, 8};
  std::string text = fmt::format("{:<{}}", cells[0], widths[0]);
  for (std::size_t i = 1; i < cells.size(); ++i) text += fmt::format("{:>{}}", cells[i], widths[i]);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

std::string thousands(std::uint64_t sum, std::uint32_t frames) {
  return fmt::format("{:.0f}", static_cast<double>(sum) / frames / 1e3);
}

void add(Cells& cells, const ImageError& error) {
  cells.push_back(std::isinf(error.psnr()) ? "same" : fmt::format("{:.2f}", error.psnr()));
  cells.push_back(std::isnan(error.ssim()) ? "-" : fmt::format("{:.5f}", error.ssim()));
  cells.push_back(fmt::format("{:.3f}", 100 * error.differing_share()));
}

}  // namespace

std::string format_table(const std::vector<SweepRow>& rows, std::uint32_t frames) {
  std::string text = fmt::format("{:21}{:-^47}  {:-^22}  {:-^22}\n", "", " per frame, in thousands; DRAM in MB ",
                                 " against M 23 ", " against binary64 ");
  text += line({"tree", "M", "time", "cycles", "rays", "nodes", "boxes", "tris", "DRAM", "PSNR", "SSIM", "differ",
                "PSNR", "SSIM", "differ"});
  text += line({"", "", "ratio", "", "", "visited", "tested", "tested", "", "dB", "", "%", "dB", "", "%"});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SweepRow& r = rows[i];
    if (i > 0 && rows[i - 1].tree != r.tree) text += "\n";
    Cells cells{tree_name(r.tree),
                format_name(r.format),
                fmt::format("{:.2f}", r.run_time),
                thousands(r.cycles, frames),
                thousands(r.rays, frames),
                thousands(r.node_visits, frames),
                thousands(r.box_tests, frames),
                thousands(r.triangle_tests, frames),
                fmt::format("{:.2f}", static_cast<double>(r.dram_bytes) / frames / 1e6)};
    add(cells, r.from_binary32);
    add(cells, r.from_binary64);
    text += line(cells);
  }
  return text;
}

std::string format_csv(const std::vector<SweepRow>& rows) {
  std::string text =
      "tree,box_bits,triangle_bits,shading_bits,"
      "cycles,rays,node_visits,box_tests,triangle_tests,dram_bytes,traced_share,"
      "psnr_from_binary32,ssim_from_binary32,differing_from_binary32,largest_from_binary32,"
      "psnr_from_binary64,ssim_from_binary64,differing_from_binary64,largest_from_binary64,run_time_ratio\n";
  const auto error = [](const ImageError& e) {
    return fmt::format("{:.6g},{:.8g},{:.8g},{}", e.psnr(), e.ssim(), e.differing_share(), e.largest());
  };
  for (const SweepRow& r : rows) {
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{:.8g},{},{},{:.4g}\n", tree_name(r.tree), r.format.box,
                    r.format.triangle, r.format.shading, r.cycles, r.rays, r.node_visits, r.box_tests, r.triangle_tests,
                    r.dram_bytes, r.traced_share, error(r.from_binary32), error(r.from_binary64), r.run_time);
  }
  return text;
}

}  // namespace artu::sim
