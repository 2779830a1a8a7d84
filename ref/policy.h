// What a threshold policy is given, and how to find one (docs/selective-rendering.md, "Policies").
//
// The contract: a policy is a function without a state.  Of the same candidate and settings it returns the same
// threshold, 0 ... 255, and it looks at nothing else.  It is asked once for each candidate, also for one that is traced
// for want of a pair.
//
// A policy NAME is the file ref/policies/NAME.cpp with `int NAME(const Candidate&, const Settings&)` in namespace
// artu::ref::policies; the list of names is made from the files (scripts/policies.cmake).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ref/passes.h"

namespace artu::ref {

struct Color {
  std::uint8_t r = 0, g = 0, b = 0;
};

/// One of the 8 at distance h.  All is at its default where `finished` is false.
struct Neighbour {
  bool finished = false;  // inside the image, and of an earlier pass
  Color color;
  HitClass hit_class = HitClass::none;  // none where interpolated
};

/// Two neighbours on opposite sides of the candidate.
struct Pair {
  Color a, b;
};

/// What is known of a candidate before its decision.
struct Candidate {
  int n_static = 0, n_dynamic = 0;
  int pairs = 0;                  // 1, of a centre 2; 0 where one is incomplete
  std::array<Pair, 2> pair;       // as many of them; horizontal before vertical
  int difference = -1;            // by the metric, summed over the pairs; -1 without one
  std::array<Neighbour, 8> ring;  // row by row: above left, above, above right, left, right, below left ...
  std::uint32_t x = 0, y = 0;
  Place place;
};

using Policy = int (*)(const Candidate& candidate, const Settings& settings);

/// Throws std::invalid_argument, with all names, where there is no such policy.
Policy policy_named(const std::string& name);

std::vector<std::string> policy_names();

/// To the range [minimum, maximum] of the settings: for policies that promise it.
int clamped(int threshold, const Settings& settings);

}  // namespace artu::ref
