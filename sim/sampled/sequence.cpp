#include "sim/sampled/sequence.h"

#include <algorithm>
#include <cmath>

#include "sim/energy/energy.h"

namespace artu::sim {

namespace {

constexpr std::uint32_t pilot = 8;

struct Field {
  const char* name;
  const char* unit;
  std::uint64_t Totals::*value;
};

/// Those of `frame_numbers` that are counted.
constexpr Field fields[] = {
    {"cycles", "cycles", &Totals::cycles},
    {"rays.primary", "rays", &Totals::rays_primary},
    {"rays.shadow", "rays", &Totals::rays_shadow},
    {"rays.reflection", "rays", &Totals::rays_reflection},
    {"rays.refraction", "rays", &Totals::rays_refraction},
    {"candidates.interpolated", "pixels", &Totals::interpolated},
    {"candidates.traced", "pixels", &Totals::traced},
    {"pixels.sampled", "pixels", &Totals::sampled},
    {"pixels.miss", "pixels", &Totals::miss},
    {"pixels.static", "pixels", &Totals::static_hits},
    {"pixels.dynamic", "pixels", &Totals::dynamic_hits},
    {"node_visits", "nodes", &Totals::node_visits},
    {"triangle_tests", "triangles", &Totals::triangle_tests},
    {"dram.read_bytes", "bytes", &Totals::dram_read_bytes},
    {"dram.write_bytes", "bytes", &Totals::dram_write_bytes},
};

std::uint64_t rounded(double value) { return static_cast<std::uint64_t>(std::llround(value)); }

template <class Figure>
TotalEstimate estimate(const FrameSample& sample, const std::vector<Totals>& totals, Figure figure) {
  std::vector<double> figures;
  figures.reserve(totals.size());
  for (const Totals& t : totals) figures.push_back(static_cast<double>(figure(t)));
  return sample.total(figures);
}

}  // namespace

std::uint32_t SampleSize::first(std::uint32_t frames) const {
  if (share == 0) return std::min(frames, pilot);
  const auto wanted = static_cast<std::uint32_t>(std::ceil(share * frames - 1e-9));
  return std::min(frames, std::max<std::uint32_t>(wanted, RegressionEstimator::fewest));
}

std::uint32_t SampleSize::needed(std::uint32_t frames, std::uint32_t drawn, double error) const {
  if (share != 0 || error <= target_error || drawn >= frames) return drawn;
  // The error falls with the square root; a part more each time, so that a bad pilot is not believed for long.
  const double ratio = error / target_error, wanted = std::min(drawn * ratio * ratio, 2.0 * drawn);
  return std::min(frames, std::max(static_cast<std::uint32_t>(std::ceil(wanted)), drawn + 1));
}

TotalEstimate estimate_cycles(const FrameSample& sample, const std::vector<Totals>& totals) {
  return estimate(sample, totals, [](const Totals& t) { return t.cycles; });
}

Totals estimate_totals(const FrameSample& sample, const std::vector<Totals>& totals, const hw::UnitConfig& unit) {
  Totals all;
  for (const Totals& frame : totals) add(all, frame);  // names, and what is the largest of a frame
  const std::uint64_t pixels = totals.front().pixels() * sample.frames();
  all.fidelity = Fidelity::sampled;
  all.frames = sample.frames();
  for (const Field& field : fields) {
    const TotalEstimate e = estimate(sample, totals, [&](const Totals& t) { return t.*field.value; });
    all.*field.value = rounded(e.value);
    all.estimates.push_back({"", field.name, field.unit, e.value, e.low, e.high});
  }
  all.interpolated = pixels - all.sampled - all.traced;  // no pixel is lost in rounding
  for (std::size_t i = 0; i < all.statistics.size(); ++i) {
    hw::Statistic& counter = all.statistics[i];
    if (is_peak(counter.name)) continue;
    const TotalEstimate e = estimate(sample, totals, [&](const Totals& t) { return t.statistics[i].value; });
    counter.value = rounded(e.value);
    all.estimates.push_back({counter.block, counter.name, counter.unit, e.value, e.low, e.high});
  }
  const TotalEstimate energy =
      estimate(sample, totals, [&](const Totals& t) { return energy_of(t, unit).picojoules() * 1e-6; });
  const auto frames = static_cast<double>(sample.frames());
  all.estimates.push_back(
      {"", "energy.frame_uj", "uJ", energy.value / frames, energy.low / frames, energy.high / frames});
  return all;
}

}  // namespace artu::sim
