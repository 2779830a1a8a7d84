// The common part of our parameter visitors: it knows the dotted path of where it is.
#pragma once

#include <string>
#include <vector>

#include "hw/fabric/parameter.h"

namespace artu::sim {

class PathVisitor : public hw::ParameterVisitor {
 public:
  void enter(const char* group, const char* text) override { groups_.emplace_back(group); }
  void leave() override { groups_.pop_back(); }

 protected:
  /// "core.node_cache" between enter and leave, "" outside of any group.
  std::string group() const {
    std::string path;
    for (const std::string& name : groups_) path += path.empty() ? name : "." + name;
    return path;
  }

  std::string path(const char* name) const { return groups_.empty() ? name : group() + "." + name; }

 private:
  std::vector<std::string> groups_;
};

}  // namespace artu::sim
