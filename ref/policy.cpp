#include "ref/policy.h"

#include <stdexcept>

namespace artu::ref {

namespace policies {
#define ARTU_POLICY(name) int name(const Candidate&, const Settings&);
#include "policies.inc"  // generated: scripts/policies.cmake
#undef ARTU_POLICY
}  // namespace policies

namespace {

struct NamedPolicy {
  const char* name;
  Policy policy;
};

#define ARTU_POLICY(name) {#name, policies::name},
constexpr NamedPolicy all_policies[] = {
#include "policies.inc"
};
#undef ARTU_POLICY

}  // namespace

Policy policy_named(const std::string& name) {
  std::string all;
  for (const NamedPolicy& known : all_policies) {
    if (name == known.name) return known.policy;
    all += std::string(all.empty() ? "" : ", ") + known.name;
  }
  throw std::invalid_argument("no policy \"" + name + "\"; there are: " + all);
}

std::vector<std::string> policy_names() {
  std::vector<std::string> names;
  for (const NamedPolicy& known : all_policies) names.emplace_back(known.name);
  return names;
}

int clamped(int threshold, const Settings& settings) {
  if (threshold < settings.minimum) return settings.minimum;
  return threshold > settings.maximum ? settings.maximum : threshold;
}

}  // namespace artu::ref
