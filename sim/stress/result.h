// What a campaign finds out about a case.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/stress/cases.h"
#include "sim/stress/subject.h"

namespace artu::sim {

/// Errors, of which the report wants quantiles: counts by size, in bins of 1/64 of an octave and less, and the largest
/// as it is.  Its memory does not grow with the number of rays.
class Distribution {
 public:
  void add(double value) {
    const auto x = static_cast<float>(value < 0 ? 0 : value);
    ++bins_[static_cast<std::uint16_t>(hw::bits_of(x) >> shift)];
    ++count_;
    largest_ = std::max(largest_, x);
  }
  void add(const Distribution& other) {
    for (const auto& [bin, count] : other.bins_) bins_[bin] += count;
    count_ += other.count_;
    largest_ = std::max(largest_, other.largest_);
  }
  std::uint64_t count() const { return count_; }
  /// The lower end of the bin, within 1.6 %; exactly the largest for a share of 1.
  double quantile(double share) const {
    if (share >= 1) return largest_;
    std::uint64_t left = static_cast<std::uint64_t>(share * static_cast<double>(count_));
    for (const auto& [bin, count] : bins_) {
      if (left < count) return hw::float_of(std::uint32_t{bin} << shift);
      left -= count;
    }
    return largest_;
  }

 private:
  static constexpr int shift = 17;  // 8 bits of exponent and 6 of fraction are left
  std::map<std::uint16_t, std::uint64_t> bins_;
  std::uint64_t count_ = 0;
  float largest_ = 0;
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
  Distribution u, v;            // of those in t_ulps; units of 2^-(M+1)
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
