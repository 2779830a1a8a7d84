#include "sim/config/parameter_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/unit_config.h"
#include "sim/config/edit_distance.h"
#include "sim/config/path_visitor.h"
#include "sim/config/text.h"

namespace artu::sim {
namespace {

class Lister : public PathVisitor {
 public:
  std::vector<ParameterInfo> parameters;
  std::vector<std::string> groups;

  void enter(const char* name, const char* text) override {
    PathVisitor::enter(name, text);
    groups.push_back(group());
  }
  void integer(const char* name, std::uint32_t& value, hw::IntegerRange range, const char* unit,
               const char* text) override {
    parameters.push_back(
        {path(name), integer_text(value), unit, range_text(range), text, ParameterKind::integer, range.power_of_two});
  }
  void real(const char* name, float& value, hw::RealRange range, const char* unit, const char* text) override {
    parameters.push_back({path(name), real_text(value), unit, range_text(range), text, ParameterKind::real});
  }
  void flag(const char* name, bool& value, const char* text) override {
    parameters.push_back({path(name), flag_text(value), "", "true, false", text, ParameterKind::flag});
  }
  void table(const char* name, hw::TableValues values, hw::IntegerRange range, const char* unit,
             const char* text) override {
    parameters.push_back({path(name), table_text(values), unit, fmt::format("{} of {}", values.size, range_text(range)),
                          text, ParameterKind::table});
  }
  void choice(const char* name, unsigned& value, const std::vector<const char*>& names, const char* text) override {
    parameters.push_back(
        {path(name), choice_text(names.at(value)), "", range_text(names), text, ParameterKind::choice});
  }
};

/// visit() hands out references to write to, hence the copy.
Lister list(hw::UnitConfig unit = {}) {
  Lister lister;
  unit.visit(lister);
  return lister;
}

std::string last_component(const std::string& path) { return path.substr(path.rfind('.') + 1); }

}  // namespace

const char* kind_name(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::integer:
      return "integer";
    case ParameterKind::real:
      return "real";
    case ParameterKind::flag:
      return "flag";
    case ParameterKind::table:
      return "table";
    default:
      return "choice";
  }
}

std::vector<ParameterInfo> parameter_list() { return list().parameters; }

std::vector<std::string> parameter_values(const hw::UnitConfig& unit) {
  std::vector<std::string> values;
  for (ParameterInfo& parameter : list(unit).parameters) values.push_back(std::move(parameter.default_value));
  return values;
}

std::vector<std::string> parameter_groups() { return list().groups; }

std::string nearest_parameter(const std::string& path) {
  const std::string wanted = path.substr(0, 200);  // a name longer than that resembles nothing
  std::string nearest;
  std::size_t best = ~std::size_t{0};
  for (const ParameterInfo& parameter : parameter_list()) {
    // A right name in the wrong group is nearer than a wrong name in the right group.
    const std::size_t distance = edit_distance(wanted, parameter.path) +
                                 2 * edit_distance(last_component(wanted), last_component(parameter.path));
    if (distance < best) {
      best = distance;
      nearest = parameter.path;
    }
  }
  return nearest;
}

std::string unknown_parameter(const std::string& path) {
  const std::string shown = path.substr(0, 200), nearest = nearest_parameter(path);
  const std::string unknown = "unknown parameter " + shown;
  const std::vector<std::string> groups = parameter_groups();
  if (std::find(groups.begin(), groups.end(), path) != groups.end()) {
    return unknown + ", which is a group; a parameter of it, such as " + nearest + ", would be right";
  }
  // The last part decides: energy.foo is not energy.box, but clock_mhz is unit.clock_mhz.
  if (resembles(last_component(shown), last_component(nearest))) return unknown + "; did you mean " + nearest + "?";
  return unknown + "; one of those that artu run --list-params prints would be right";
}

std::string format_parameter_list() {
  const std::vector<ParameterInfo> parameters = parameter_list();
  std::size_t path = 4, value = 7, unit = 4, range = 5;
  for (const ParameterInfo& p : parameters) {
    path = std::max(path, p.path.size());
    value = std::max(value, p.default_value.size());
    unit = std::max(unit, p.unit.size());
    range = std::max(range, p.range.size());
  }
  const auto line = [&](const ParameterInfo& p) {
    return fmt::format("{:<{}}  {:<{}}  {:<{}}  {:<{}}  {}\n", p.path, path, p.default_value, value, p.unit, unit,
                       p.range, range, p.text);
  };
  std::string out = line({"path", "default", "unit", "range", "text"});
  for (const ParameterInfo& p : parameters) out += line(p);
  return out;
}

}  // namespace artu::sim
