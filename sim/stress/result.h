// What a campaign finds out about a case.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/stress/cases.h"
#include "sim/stress/subject.h"

namespace artu::sim {

/// Errors, of which the report wants quantiles.
class Distribution {
 public:
  void add(double value) { values_.push_back(static_cast<float>(value)); }
  void add(const Distribution& other) { values_.insert(values_.end(), other.values_.begin(), other.values_.end()); }
  std::size_t count() const { return values_.size(); }
  double quantile(double share) const {
    if (values_.empty()) return 0;
    std::vector<float> sorted = values_;
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return *at;
  }

 private:
  std::vector<float> values_;
};

/// One subject against brute force.
struct Tally {
  std::string name;
  std::uint64_t compared = 0, mismatches = 0;
};

/// Events among trials.
struct Count {
  std::uint64_t tried = 0, happened = 0;
  void add(bool event) {
    ++tried;
    happened += event ? 1 : 0;
  }
  void add(const Count& other) {
    tried += other.tried;
    happened += other.happened;
  }
  double rate() const { return tried == 0 ? 0 : static_cast<double>(happened) / static_cast<double>(tried); }
};

/// A ray with two answers: all that is needed to make a regression test of it.
struct Failure {
  std::string what, case_name, ray_kind;
  std::uint64_t index = 0;  // of the ray in its case
  hw::Ray ray;
  Answer expected, found;
  bool occlusion = false;  // the answers differ in whether there is any hit
  bool found_occluded = false;
  std::optional<Corners> expected_triangle, found_triangle;
};

struct Accuracy {
  Distribution t_ulps;          // hits away from edges that neither graze nor begin on the surface or far away
  Distribution t_ulps_all;      // all hits away from edges
  Distribution u, v;            // of those in t_ulps; units of 2^-24
  Count decisions;              // hit or miss against exact where it is clear
  std::uint64_t explained = 0;  // of those that differ: nearer to an edge than rounding of the vertices
};

struct CaseResult {
  StressCase name;
  std::size_t triangles = 0;
  std::uint64_t rays = 0, hits = 0, secondary = 0;  // secondary rays that were compared as well
  std::vector<Tally> tallies;
  Count leaks;
  Count self_out, self_in;  // rays from Pout and Pin that hit their own triangle
  Count convex;             // rays from Pout of a convex body that hit it again
  Accuracy accuracy;
  std::optional<Failure> first;

  std::uint64_t mismatches() const {
    std::uint64_t sum = 0;
    for (const Tally& tally : tallies) sum += tally.mismatches;
    return sum;
  }
};

}  // namespace artu::sim
