#include "sim/quality/policies.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/selective/policy.h"
#include "traces/error.h"

namespace artu::sim {

const std::vector<Policy>& all_policies() {
  static const std::vector<Policy> policies = [] {
    std::vector<Policy> all;
    for (const char* name : hw::policy_names()) {
      all.push_back({name, {fmt::format("selective.policy={}", name)}});
    }
    std::stable_partition(all.begin(), all.end(), [](const Policy& policy) { return policy.name == plain_policy; });
    return all;
  }();
  return policies;
}

std::vector<Policy> parse_policies(const std::string& text) {
  std::vector<Policy> chosen;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string name = text.substr(at, end - at);
    const auto is_it = [&](const Policy& policy) { return policy.name == name; };
    const auto known = std::find_if(all_policies().begin(), all_policies().end(), is_it);
    if (known == all_policies().end()) {
      std::string names;
      for (const Policy& policy : all_policies()) names += (names.empty() ? "" : ", ") + policy.name;
      throw InputError("--policies", fmt::format("\"{}\" is no policy; of {}, with commas between them, would be right",
                                                 name, names));
    }
    if (std::none_of(chosen.begin(), chosen.end(), is_it)) chosen.push_back(*known);
    at = end + 1;
  }
  return chosen;
}

}  // namespace artu::sim
