// The policies that `artu quality` holds against each other: all that the unit has (hw/selective/policy.h).
#pragma once

#include <string>
#include <vector>

namespace artu::sim {

struct Policy {
  std::string name;
  std::vector<std::string> assignments;  // as of --set; they go over those of the command line
};

/// The plain one first.
const std::vector<Policy>& all_policies();

/// The one that the others' gain is counted from.
inline constexpr const char* plain_policy = "fixed";

/// Names between commas.  Throws InputError.
std::vector<Policy> parse_policies(const std::string& text);

}  // namespace artu::sim
