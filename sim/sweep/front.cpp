#include "sim/sweep/front.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace artu::sim {
namespace {

struct Candidate {
  std::size_t place = 0;
  std::vector<double> values;  // by objective, the smaller the better
};

std::size_t column_of(const SweepTable& table, const std::string& name) {
  return static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), name) - table.columns.begin());
}

/// Better by more than the share of the value.
bool exceeds(double a, double b, double margin) { return b - a > margin * std::abs(b); }

bool dominates(const Candidate& a, const Candidate& b, double margin) {
  bool better = false;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (margin > 0 ? !exceeds(a.values[i], b.values[i], margin) : a.values[i] > b.values[i]) return false;
    better = better || a.values[i] < b.values[i];
  }
  return better;
}

}  // namespace

std::vector<std::size_t> front_of(const SweepTable& table, const std::vector<Objective>& objectives, double margin) {
  const std::size_t status = column_of(table, "status"), scene = column_of(table, "scene"),
                    frames = column_of(table, "frames"), size = column_of(table, "size");
  std::vector<Candidate> candidates;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    Candidate candidate{r, {}};
    for (const Objective& objective : objectives) {
      const std::size_t column = column_of(table, objective.figure);
      if (column == table.columns.size() || !table.rows[r][column].is_number()) break;
      const double value = table.rows[r][column].get<double>();
      candidate.values.push_back(objective.maximise ? -value : value);
    }
    const bool known = table.rows[r][status] == "ok" && candidate.values.size() == objectives.size();
    if (known && !objectives.empty()) candidates.push_back(candidate);
  }
  std::vector<std::size_t> front;
  for (const Candidate& own : candidates) {
    const auto better = [&](const Candidate& other) {
      const auto &a = table.rows[own.place], &b = table.rows[other.place];
      return a[scene] == b[scene] && a[frames] == b[frames] && a[size] == b[size] && dominates(other, own, margin);
    };
    if (std::none_of(candidates.begin(), candidates.end(), better)) front.push_back(own.place);
  }
  return front;
}

}  // namespace artu::sim
