#include <fmt/format.h>

#include "sim/quality/front.h"
#include "sim/quality/policies.h"
#include "sim/quality/report.h"

namespace artu::sim {
namespace {

std::string point_of(const QualityRow& row) {
  return fmt::format("{},{}", row.policy, row.reference ? fmt::format("{}", *row.reference) : "");
}

template <class T>
std::string cell(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string decided_cells(const Decided& what) {
  return fmt::format("{},{},{},{}", what.pass, cause_names[static_cast<std::size_t>(what.cause)], what.pair(),
                     area_names[static_cast<std::size_t>(what.pixel)]);
}

double share_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

std::string quality_csv(const std::vector<QualityRow>& rows) {
  std::string text = "policy,reference,traced_share,rays,cycles,dram_bytes,energy_pj";
  for (const char* area : area_names) {
    text += fmt::format(",pixels_{0},squares_{0},psnr_{0},ssim_{0},flip_{0}", area);
  }
  text += "\n";
  for (const QualityRow& row : rows) {
    text += fmt::format("{},{:.8g},{},{},{},{}", point_of(row), row.traced_share(), row.rays, cell(row.cycles),
                        cell(row.dram_bytes), row.picojoules ? fmt::format("{:.8g}", *row.picojoules) : "");
    for (const AreaError& e : row.errors.areas) {
      text += fmt::format(",{},{},{:.6g},{:.8g},{:.8g}", e.pixels, e.squares, e.psnr(), e.mean_ssim(), e.mean_flip());
    }
    text += "\n";
  }
  return text;
}

std::string equal_shares_csv(const std::vector<QualityRow>& rows, const std::vector<double>& shares) {
  std::string text = "traced_share,policy";
  for (const char* area : area_names) text += fmt::format(",psnr_{0},gain_{0}", area);
  text += ",flip_all,flip_gain_all\n";
  for (const double share : shares) {
    const FrontValue plain = front_at(rows, plain_policy, share);
    for (const std::string& policy : policies_of(rows)) {
      const FrontValue value = front_at(rows, policy, share);
      text += fmt::format("{:g},{}", share, policy);
      for (std::size_t i = 0; i < area_count; ++i) {
        text += fmt::format(",{:.6g},{:.6g}", value.psnr[i], value.psnr[i] - plain.psnr[i]);
      }
      text += fmt::format(",{:.8g},{:.6g}\n", value.flip, plain.flip - value.flip);
    }
  }
  return text;
}

std::string attribution_csv(const std::vector<QualityRow>& rows) {
  std::string text = "policy,reference,pass,cause,pair,pixel,pixels,pixel_share,squares,square_share\n";
  for (const QualityRow& row : rows) {
    if (!row.attribution) continue;
    const std::uint64_t squares = row.attribution->squares();
    for (const auto& [what, share] : row.attribution->shares()) {
      text += fmt::format("{},{},{},{:.8g},{},{:.8g}\n", point_of(row), decided_cells(what), share.pixels,
                          share_of(share.pixels, row.pixels), share.squares, share_of(share.squares, squares));
    }
  }
  return text;
}

std::string worst_pixels_csv(const std::vector<QualityRow>& rows) {
  std::string text =
      "policy,reference,frame,x,y,pass,cause,pair,pixel,threshold,difference,r,g,b,full_r,full_g,full_b,squares\n";
  for (const QualityRow& row : rows) {
    if (!row.attribution) continue;
    for (const WrongPixel& p : row.attribution->worst()) {
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", point_of(row), p.frame, p.x, p.y,
                          decided_cells(p.decided), p.threshold, p.difference, p.got[0], p.got[1], p.got[2], p.full[0],
                          p.full[1], p.full[2], p.squares);
    }
  }
  return text;
}

}  // namespace artu::sim
