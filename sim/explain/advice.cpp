#include "sim/explain/advice.h"

#include <algorithm>
#include <stdexcept>

#include "sim/config/configuration.h"
#include "sim/config/path_visitor.h"
#include "sim/config/text.h"
#include "sim/explain/steps.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

class Reader : public PathVisitor {
 public:
  explicit Reader(std::string wanted) : wanted_(std::move(wanted)) {}
  std::optional<std::string> found;

  void integer(const char* name, std::uint32_t& value, hw::IntegerRange, const char*, const char*) override {
    if (path(name) == wanted_) found = integer_text(value);
  }
  void real(const char* name, float& value, hw::RealRange, const char*, const char*) override {
    if (path(name) == wanted_) found = real_text(value);
  }
  void flag(const char* name, bool& value, const char*) override {
    if (path(name) == wanted_) found = flag_text(value);
  }
  void table(const char* name, hw::TableValues values, hw::IntegerRange, const char*, const char*) override {
    if (path(name) == wanted_) found = table_text(values);
  }
  void choice(const char* name, unsigned& value, const std::vector<const char*>& names, const char*) override {
    if (path(name) == wanted_) found = choice_text(names.at(value));
  }

 private:
  const std::string wanted_;
};

struct Floor {
  double cycles = 0;
  std::string of;  // what it is made of
};

/// The phases that are left, and the passes' largest need.
Floor floor_of(const Accounting& now, const Accounting& then, const Step& step) {
  Floor floor;
  floor.of = "what is left of the tree's build";
  double passes = 0;
  for (std::size_t i = 0; i < resource_count; ++i) {
    const auto resource = static_cast<Resource>(i);
    if (step.relieves.count(resource) != 0 || then.need(resource) <= passes) continue;
    passes = then.need(resource);
    floor.of = std::string("the ") + name_of(resource);
  }
  // Twice as much of one thing does not more than halve the time.
  if (step.at_most != 0 && passes < now.passes() / step.at_most) {
    passes = now.passes() / step.at_most;
    floor.of = "itself, since it is turned by a step";
  }
  const double flush = now.flush * step.flush_left;
  const double start = step.shortens_start ? 0 : now.start;
  if (now.builder_overlaps) {
    const double builder = std::max(now.builder - step.build_saved, 0.0);
    if (builder > passes) floor.of = "the tree's build";
    floor.cycles = start + std::max(builder, passes) + flush;
  } else {
    const double build = std::max(now.build - step.build_saved, 0.0);
    if (build > passes) floor.of = "the tree's build";
    if (flush > std::max(build, passes)) floor.of = "the write-back";
    floor.cycles = start + build + passes + flush;
  }
  floor.cycles = std::min(floor.cycles, now.cycles);
  return floor;
}

}  // namespace

std::string value_of(const hw::UnitConfig& unit, const std::string& parameter) {
  hw::UnitConfig copy = unit;  // visit() hands out references to write to
  Reader reader(parameter);
  copy.visit(reader);
  if (!reader.found) throw std::logic_error("explain: no parameter " + parameter);
  return *reader.found;
}

std::optional<hw::UnitConfig> with(const hw::UnitConfig& unit, const std::string& parameter, const std::string& value) {
  try {
    Configuration changed(unit);
    changed.set(parameter + "=" + value);
    changed.check();
    return changed.unit();
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<Advice> advice_on(const Finding& finding, const Totals& totals, const hw::UnitConfig& unit) {
  const Accounting now = account(totals, unit);
  std::vector<Advice> advices;
  for (const Step& step : steps_for(finding, now, totals, unit)) {
    const std::string from = value_of(unit, step.parameter);
    if (from == step.to) continue;
    const std::optional<hw::UnitConfig> changed = with(unit, step.parameter, step.to);
    if (!changed) continue;
    const Accounting then = account(totals, *changed);
    Step endless = step;
    endless.at_most = 0;
    endless.build_saved = step.build_saved_far;
    if (finding.throughput) endless.relieves.insert(finding.resource);
    const Floor floor = floor_of(now, then, step), far = floor_of(now, then, endless);
    if (floor.cycles > 0.99 * now.cycles) continue;
    advices.push_back({step.parameter, from, step.to, *changed, floor.cycles, far.cycles, far.of});
    if (advices.size() == 3) break;
  }
  return advices;
}

}  // namespace artu::sim
