#include "sim/config/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace artu::sim {

std::string range_text(const hw::IntegerRange& range) {
  if (range.minimum == range.maximum) return fmt::format("{}", range.minimum);
  return fmt::format("{} ... {}{}", range.minimum, range.maximum, range.power_of_two ? ", a power of two" : "");
}

std::string range_text(const hw::RealRange& range) { return fmt::format("{} ... {}", range.minimum, range.maximum); }

std::string range_text(const std::vector<const char*>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::string integer_text(std::uint32_t value) { return fmt::format("{}", value); }

std::string real_text(float value) {
  std::string text = fmt::format("{}", value);  // the shortest that reads back to the same bits
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string flag_text(bool value) { return value ? "true" : "false"; }

std::string choice_text(const char* name) { return fmt::format("\"{}\"", name); }

std::string table_text(hw::TableValues values) { return fmt::format("[{}]", fmt::join(values, ", ")); }

}  // namespace artu::sim
