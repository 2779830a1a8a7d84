#include "ref/policy.h"

#include <stdexcept>

#include "ref/policy_list.h"

namespace artu::ref {

Policy policy_named(const std::string& name) {
  std::string all;
  for (const NamedPolicy& known : policy_list()) {
    if (name == known.name) return known.policy;
    all += std::string(all.empty() ? "" : ", ") + known.name;
  }
  throw std::invalid_argument("no policy \"" + name + "\"; there are: " + all);
}

std::vector<std::string> policy_names() {
  std::vector<std::string> names;
  for (const NamedPolicy& known : policy_list()) names.emplace_back(known.name);
  return names;
}

int clamped(int threshold, const Settings& settings) {
  if (threshold < settings.minimum) return settings.minimum;
  return threshold > settings.maximum ? settings.maximum : threshold;
}

}  // namespace artu::ref
