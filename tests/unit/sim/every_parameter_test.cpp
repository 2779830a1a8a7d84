// Each of the parameters, whatever they are: it can be set, it is dumped, and what is outside its range is refused.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "sim/config/configuration.h"
#include "sim/config/dump.h"
#include "sim/config/parameter_list.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using ::testing::HasSubstr;

/// Words between commas.
std::vector<std::string> choices(const std::string& range) {
  std::vector<std::string> words;
  std::istringstream in(range);
  for (std::string word; std::getline(in >> std::ws, word, ',');) words.push_back(word);
  return words;
}

struct Limits {
  double low = 0, high = 0;
};

/// Of "LOW ... HIGH" with whatever follows.
Limits limits(const std::string& range) {
  Limits out;
  std::string dots;
  std::istringstream(range) >> out.low >> dots >> out.high;
  return out;
}

/// As TOML, of what the list says of the parameter.
std::string number(double value, ParameterKind kind) {
  std::ostringstream out;
  out.precision(17);
  if (kind == ParameterKind::integer) {
    out << static_cast<long long>(value);
  } else {
    out << value;
  }
  return out.str();
}

std::vector<std::string> inside(const ParameterInfo& parameter) {
  if (parameter.kind == ParameterKind::flag) return {"true", "false"};
  if (parameter.kind == ParameterKind::choice) return choices(parameter.range);
  if (parameter.kind == ParameterKind::table) {
    std::string ones = parameter.default_value;  // the same number of entries
    for (const char digit : std::string("023456789")) std::replace(ones.begin(), ones.end(), digit, '1');
    return {ones};
  }
  const Limits range = limits(parameter.range);
  const double now = std::stod(parameter.default_value);
  std::vector<std::string> values;
  for (const double value : {now * 2, now / 2, now + 1, now - 1, range.low, range.high}) {
    if (value < range.low || value > range.high || value == now) continue;
    values.push_back(number(value, parameter.kind));
  }
  return values;
}

std::vector<std::string> outside(const ParameterInfo& parameter) {
  switch (parameter.kind) {
    case ParameterKind::flag:
      return {"1", "yes"};
    case ParameterKind::choice:
      return {"nothing", "1"};
    case ParameterKind::table:
      return {"1", "[1]", "[1, 2, 3, 4, 5, 6, 7, 256]"};
    case ParameterKind::integer:
    case ParameterKind::real:
      break;
  }
  const Limits range = limits(parameter.range);
  std::vector<std::string> values{number(range.low - 1, parameter.kind), number(range.high + 1, parameter.kind),
                                  "many"};
  if (parameter.kind == ParameterKind::real) values.back() = "nan";
  if (parameter.power_of_two) values.push_back(number(range.high - 1, parameter.kind));
  return values;
}

/// What the unit has of the parameter, as TOML.
std::string value_in(const hw::UnitConfig& unit, const std::string& path) {
  const std::vector<ParameterInfo> all = parameter_list();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].path == path) return parameter_values(unit)[i];
  }
  return "";
}

/// A value may not go with the defaults of other parameters; then it is refused for that, and another one will do.
TEST(EveryParameter, TakesAnotherValueThanItsDefault) {
  for (const ParameterInfo& parameter : parameter_list()) {
    if (parameter.range == parameter.default_value) continue;  // there is no other
    bool taken = false;
    std::string why;
    for (const std::string& value : inside(parameter)) {
      std::vector<std::string> assignments{parameter.path + "=" + value};
      if (parameter.path == "selective.count") assignments.push_back("selective.compare=reference-count");
      try {
        const hw::UnitConfig unit = Configuration::of({}, assignments).unit();
        const std::string now = value_in(unit, parameter.path);
        if (now == parameter.default_value) continue;
        taken = true;
        const std::string name = parameter.path.substr(parameter.path.rfind('.') + 1);
        EXPECT_THAT(dump_config(unit), HasSubstr("\n" + name + " = " + now)) << parameter.path;
      } catch (const InputError& error) {
        why += std::string("\n") + error.what();
      }
    }
    EXPECT_TRUE(taken) << parameter.path << why;
  }
}

TEST(EveryParameter, RefusesWhatIsOutsideItsRange) {
  for (const ParameterInfo& parameter : parameter_list()) {
    for (const std::string& value : outside(parameter)) {
      try {
        Configuration::of({}, {parameter.path + "=" + value}).unit();
        ADD_FAILURE() << parameter.path << " = " << value << " is taken";
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(parameter.path)) << value;
      }
    }
  }
}

}  // namespace
}  // namespace artu::sim
