#include "sim/quality/front.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace artu::sim {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

FrontValue values_of(const QualityRow& row) {
  FrontValue value;
  for (std::size_t i = 0; i < area_count; ++i) {
    const double psnr = row.errors.areas[i].psnr();
    value.psnr[i] = std::isfinite(psnr) ? psnr : unknown;
  }
  value.flip = row.errors.of(Area::whole).mean_flip();
  return value;
}

FrontValue between(const FrontValue& a, const FrontValue& b, double part) {
  const auto mix = [&](double from, double to) {
    return part == 0 ? from : part == 1 ? to : from + part * (to - from);
  };
  FrontValue value;
  for (std::size_t i = 0; i < area_count; ++i) value.psnr[i] = mix(a.psnr[i], b.psnr[i]);
  value.flip = mix(a.flip, b.flip);
  return value;
}

}  // namespace

FrontValue front_at(const std::vector<QualityRow>& rows, const std::string& policy, double traced_share) {
  std::vector<const QualityRow*> points;
  for (const QualityRow& row : rows) {
    if (row.reference && row.policy == policy) points.push_back(&row);
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const QualityRow* a, const QualityRow* b) { return a->traced_share() < b->traced_share(); });
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i]->traced_share() == traced_share) return values_of(*points[i]);
    if (i == 0 || points[i]->traced_share() < traced_share || points[i - 1]->traced_share() > traced_share) continue;
    const double from = points[i - 1]->traced_share(), to = points[i]->traced_share();
    return between(values_of(*points[i - 1]), values_of(*points[i]), (traced_share - from) / (to - from));
  }
  return {{unknown, unknown, unknown, unknown}, unknown};
}

std::vector<std::string> policies_of(const std::vector<QualityRow>& rows) {
  std::vector<std::string> policies;
  for (const QualityRow& row : rows) {
    if (row.reference && std::find(policies.begin(), policies.end(), row.policy) == policies.end()) {
      policies.push_back(row.policy);
    }
  }
  return policies;
}

}  // namespace artu::sim
