#include <algorithm>

#include "sim/precision/report.h"

namespace artu::sim {

std::string file_name(const std::string& picture_name) {
  std::string name = picture_name;
  std::replace(name.begin(), name.end(), '/', '-');
  if (name.size() == 2) name.insert(1, "0");  // "M7", so that names are in the order of the widths
  return name;
}

}  // namespace artu::sim
