#include "hw/selective/policy.h"

namespace artu::hw {

namespace policies {
#define ARTU_POLICY(name) Policy name();
#include "policies.inc"  // generated: scripts/policies.cmake
#undef ARTU_POLICY
}  // namespace policies

const std::vector<const char*>& policy_names() {
#define ARTU_POLICY(name) #name,
  static const std::vector<const char*> names{
#include "policies.inc"
  };
#undef ARTU_POLICY
  return names;
}

const Policy& policy(std::uint32_t number) {
#define ARTU_POLICY(name) policies::name(),
  static const std::vector<Policy> all{
#include "policies.inc"
  };
#undef ARTU_POLICY
  return all.at(number);
}

}  // namespace artu::hw
