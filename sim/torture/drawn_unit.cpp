#include "sim/torture/drawn_unit.h"

#include <algorithm>
#include <cmath>

#include "sim/config/configuration.h"
#include "sim/config/path_visitor.h"
#include "sim/config/text.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

class Drawer : public PathVisitor {
 public:
  Drawer(Random& random, float share) : random_(random), share_(share) {}

  std::vector<std::string> assignments;

  void integer(const char* name, std::uint32_t&, hw::IntegerRange range, const char* unit, const char*) override {
    const bool bytes = std::string(unit) == "bytes";
    range.maximum = std::max(range.minimum, std::min(range.maximum, bytes ? 1u << 20 : range.maximum));
    if (path(name) == "unit.watchdog") return;
    give(name, [&] { return integer_text(number(range)); });
  }
  void real(const char* name, float&, hw::RealRange range, const char*, const char*) override {
    give(name, [&] {
      const auto low = static_cast<float>(range.minimum), high = static_cast<float>(range.maximum);
      return real_text(std::clamp(random_.between(low, high), low, high));
    });
  }
  void flag(const char* name, bool&, const char*) override {
    give(name, [&] { return flag_text(random_.below(2) != 0); });
  }
  void table(const char* name, hw::TableValues values, hw::IntegerRange range, const char*, const char*) override {
    give(name, [&] {
      std::vector<std::uint32_t> drawn(values.size);
      for (std::uint32_t& value : drawn) value = number(range);
      return table_text({drawn.data(), drawn.size()});
    });
  }
  void choice(const char* name, unsigned&, const std::vector<const char*>& names, const char*) override {
    give(name, [&] { return choice_text(names[random_.below(names.size())]); });
  }

 private:
  template <class Value>
  void give(const char* name, Value value) {
    if (random_.share() < share_) assignments.push_back(path(name) + "=" + value());
  }

  /// As often between 1 and 2 as between 512 and 1024: the small ones are where a unit gets stuck.
  std::uint32_t number(const hw::IntegerRange& range) {
    const auto bits = [](std::uint64_t value) { return std::log2(static_cast<double>(value)); };
    const double low = bits(std::uint64_t{range.minimum} + 1), high = bits(std::uint64_t{range.maximum} + 2);
    const double drawn = std::exp2(low + (high - low) * static_cast<double>(random_.share())) - 1;
    const auto whole = static_cast<std::uint64_t>(std::max(drawn, 0.0));
    auto value =
        static_cast<std::uint32_t>(std::clamp(whole, std::uint64_t{range.minimum}, std::uint64_t{range.maximum}));
    if (!range.power_of_two) return value;
    std::uint32_t power = 1;
    while (power < range.minimum || (power <= value / 2 && power <= range.maximum / 2)) power *= 2;
    return power;
  }

  Random& random_;
  const float share_;
};

bool accepted(const std::vector<std::string>& assignments) {
  try {
    Configuration::of({}, assignments);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

std::vector<std::string> draw_assignments(Random& random) {
  hw::UnitConfig defaults;
  Drawer drawer(random, random.between(0.02f, 0.6f));
  defaults.visit(drawer);
  return drawer.assignments;
}

std::vector<std::string> draw_unit(Random& random) {
  std::vector<std::string> drawn = draw_assignments(random);
  if (accepted(drawn)) return drawn;
  std::vector<std::string> kept;
  for (const std::string& assignment : drawn) {
    kept.push_back(assignment);
    if (!accepted(kept)) kept.pop_back();
  }
  return kept;
}

}  // namespace artu::sim
