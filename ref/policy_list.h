// The policies of ref/policies; the list itself is generated (ref/CMakeLists.txt).
#pragma once

#include <vector>

#include "ref/policy.h"

namespace artu::ref {

struct NamedPolicy {
  const char* name;
  Policy policy;
};

const std::vector<NamedPolicy>& policy_list();

}  // namespace artu::ref
