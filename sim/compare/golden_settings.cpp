#include "sim/compare/golden_settings.h"

#include <fmt/format.h>

#include "hw/selective/policy.h"
#include "ref/policy.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

// The two rooms declare the same enumerations on their own; a number means the same in both.
template <class A, class B>
constexpr bool same(A a, B b) {
  return static_cast<int>(a) == static_cast<int>(b);
}
static_assert(same(hw::Passes::horizontal_vertical, ref::Passes::horizontal_vertical));
static_assert(same(hw::Passes::average, ref::Passes::average));
static_assert(same(hw::Count::per_class, ref::Count::per_class) && same(hw::Count::merged, ref::Count::merged));
static_assert(same(hw::Compare::dynamic_vs_static, ref::Compare::dynamic_vs_static));
static_assert(same(hw::Compare::reference_count, ref::Compare::reference_count));
static_assert(same(hw::Metric::max_channel, ref::Metric::max_channel));
static_assert(same(hw::Metric::sum, ref::Metric::sum) && same(hw::Metric::luma, ref::Metric::luma));
static_assert(same(hw::Magnitude::fixed, ref::Magnitude::fixed));
static_assert(same(hw::Magnitude::proportional, ref::Magnitude::proportional));
static_assert(same(hw::Magnitude::progressive, ref::Magnitude::progressive));

}  // namespace

std::string twin_of(const std::string& policy) {
  std::string all;
  for (const std::string& name : ref::policy_names()) {
    if (name == policy) return policy;
    all += (all.empty() ? "" : ", ") + name;
  }
  throw InputError(
      "selective.policy",
      fmt::format("the golden model has no \"{0}\"; ref/policies/{0}.cpp, or one of {1}, would be right", policy, all));
}

ref::Settings golden_settings(const hw::UnitConfig& unit) {
  const hw::SelectiveConfig& from = unit.selective;
  ref::Settings to;
  to.selective = from.enabled;
  to.adaptive = from.adaptive;
  to.stride = static_cast<int>(from.stride);
  to.passes = static_cast<ref::Passes>(from.passes);
  to.policy = twin_of(hw::policy_names()[from.policy]);
  for (std::size_t i = 0; i < to.policy_registers.size(); ++i) {
    to.policy_registers[i] = static_cast<int>(from.policy_registers[i]);
  }
  to.count = static_cast<ref::Count>(from.count);
  to.compare = static_cast<ref::Compare>(from.compare);
  to.reference_count = static_cast<int>(from.reference_count);
  to.metric = static_cast<ref::Metric>(from.metric);
  to.magnitude = static_cast<ref::Magnitude>(from.magnitude);
  to.reference = static_cast<int>(from.reference);
  to.minimum = static_cast<int>(from.minimum);
  to.maximum = static_cast<int>(from.maximum);
  to.step = static_cast<int>(from.step);
  for (std::size_t i = 0; i < to.table.size(); ++i) to.table[i] = static_cast<int>(from.table[i]);
  to.max_depth = unit.shading.max_depth;
  to.min_weight = unit.shading.min_weight;
  to.every_light = !unit.skip.shadow;
  to.precision = {static_cast<int>(unit.precision.box), static_cast<int>(unit.precision.triangle),
                  static_cast<int>(unit.precision.shading)};
  return to;
}

}  // namespace artu::sim
