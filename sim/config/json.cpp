#include "sim/config/json.h"

#include <nlohmann/json.hpp>
#include <vector>

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

class Collector : public hw::ParameterVisitor {
 public:
  Json root = Json::object();

  void enter(const char* group, const char*) override {
    Json& inner = (*places_.back())[group];
    if (inner.is_null()) inner = Json::object();
    places_.push_back(&inner);
  }
  void leave() override { places_.pop_back(); }
  void integer(const char* name, std::uint32_t& value, hw::IntegerRange, const char*, const char*) override {
    here(name) = value;
  }
  void real(const char* name, float& value, hw::RealRange, const char*, const char*) override { here(name) = value; }
  void flag(const char* name, bool& value, const char*) override { here(name) = value; }
  void table(const char* name, hw::TableValues values, hw::IntegerRange, const char*, const char*) override {
    here(name) = std::vector<std::uint32_t>(values.begin(), values.end());
  }
  void choice(const char* name, unsigned& value, const std::vector<const char*>& names, const char*) override {
    here(name) = names.at(value);
  }

 private:
  Json& here(const char* name) { return (*places_.back())[name]; }

  // Only the innermost object grows while it is the last: no pointer to an outer one moves.
  std::vector<Json*> places_{&root};
};

}  // namespace

Json json_of(const hw::UnitConfig& config) {
  hw::UnitConfig copy = config;  // visit() hands out references to write to
  Collector collector;
  copy.visit(collector);
  return collector.root;
}

}  // namespace artu::sim
