// A policy: how much two colours may differ for a candidate between them to be interpolated
// (docs/selective-rendering.md, "Policies" and "Adding a policy"). The threshold adjuster is a pipeline around it.
//
// The contract: `threshold` is a function without a state; it depends on its two arguments alone, and the golden
// model's policy of the same name computes the same. The pipeline takes a candidate a cycle whatever the policy.
//
// A policy is a file of hw/selective/policies, `NAME.cpp`, that defines `Policy NAME()` in namespace
// artu::hw::policies. The build finds it; the parameter `selective.policy`, lists and messages know it by then.
#pragma once

#include <vector>

#include "hw/datapath/selective.h"

namespace artu::hw {

struct Policy {
  std::uint32_t latency;     // cycles from a candidate to its threshold, at least 1
  std::uint32_t operations;  // on 8-bit integers, a candidate: for the energy
  std::uint8_t (*threshold)(const Evidence&, const SelectiveConfig&);
};

/// In the order of `SelectiveConfig::policy`: attention first, the others by name.
const std::vector<const char*>& policy_names();

const Policy& policy(std::uint32_t number);

}  // namespace artu::hw
