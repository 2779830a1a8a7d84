#include "traces/check.h"

#include <cmath>
#include <cstdio>

#include "traces/error.h"
#include "traces/limits.h"
#include "traces/validate.h"

namespace artu::traces {
namespace {

template <typename Test>
const char* first_bad(const Vec3& v, float& value, Test good) {
  const char* bad = !good(v.x) ? ".x" : !good(v.y) ? ".y" : !good(v.z) ? ".z" : nullptr;
  if (bad) value = bad[1] == 'x' ? v.x : bad[1] == 'y' ? v.y : v.z;
  return bad;
}

bool is_coordinate(float f) { return std::fabs(f) < coordinate_limit; }  // false for NaN
bool is_weight(float f) { return f >= 0 && f < coordinate_limit; }

/// Length of the UTF-8 sequence at `s`, 0 if there is none or if it is a control character.  The text
/// goes to terminals and into JSON.
std::size_t character(const unsigned char* s, std::size_t left) {
  const auto follows = [&](std::size_t i) { return i < left && (s[i] & 0xC0) == 0x80; };
  if (s[0] < 0x80) return s[0] >= 0x20 && s[0] != 0x7F ? 1 : 0;
  if (s[0] >= 0xC2 && s[0] <= 0xDF) return follows(1) && (s[0] > 0xC2 || s[1] >= 0xA0) ? 2 : 0;
  if (s[0] >= 0xE0 && s[0] <= 0xEF) {
    if (!follows(1) || !follows(2)) return 0;
    const bool overlong = s[0] == 0xE0 && s[1] < 0xA0, surrogate = s[0] == 0xED && s[1] >= 0xA0;
    return overlong || surrogate ? 0 : 3;
  }
  if (s[0] >= 0xF0 && s[0] <= 0xF4) {
    if (!follows(1) || !follows(2) || !follows(3)) return 0;
    const bool overlong = s[0] == 0xF0 && s[1] < 0x90, beyond = s[0] == 0xF4 && s[1] >= 0x90;
    return overlong || beyond ? 0 : 4;
  }
  return 0;
}

std::string format(const char* with, double value) {
  char text[32];
  std::snprintf(text, sizeof(text), with, value);
  // The sign of a NaN says nothing, and not every library prints it.
  return std::isnan(value) ? "nan" : text;
}

}  // namespace

void Check::coordinate(const char* field, float value) const {
  if (!is_coordinate(value)) fail(field, value, coordinate_range);
}

void Check::coordinate(const char* field, const Vec3& v) const {
  float value = 0;
  if (const char* bad = first_bad(v, value, is_coordinate)) fail(std::string(field) + bad, value, coordinate_range);
}

void Check::weight(const char* field, const Vec3& v) const {
  float value = 0;
  if (const char* bad = first_bad(v, value, is_weight)) {
    fail(std::string(field) + bad, value, "finite, not negative and below 2^62");
  }
}

void Check::text(const char* field, const std::string& value) const {
  if (value.size() > max_text) {
    refuse(std::string(field) + " has " + std::to_string(value.size()) + " bytes; must have at most " +
           std::to_string(max_text));
  }
  const auto* s = reinterpret_cast<const unsigned char*>(value.data());
  for (std::size_t i = 0; i < value.size();) {
    const std::size_t length = character(s + i, value.size() - i);
    if (length == 0) {
      fail(std::string("byte ") + std::to_string(i) + " of " + field, static_cast<int>(s[i]),
           "UTF-8 text without control characters");
    }
    i += length;
  }
}

void Check::side(const char* field, std::uint32_t value) const {
  that(value >= 1 && value <= max_side, field, value, "1 ... 16384");
}

void Check::enumeration(const char* field, std::uint8_t value, const char* range) const {
  that(value <= 2, field, int{value}, range);
}

void Check::at_most(const char* field, std::size_t value, std::size_t most) const {
  if (value > most) fail(field, value, "at most " + std::to_string(most));
}

void Check::size(const char* array, std::size_t size, std::size_t expected, const std::string& why) const {
  if (size == expected) return;
  refuse(std::string(array) + " has " + std::to_string(size) + " elements; must have " + std::to_string(expected) +
         why);
}

std::string Check::at(const char* array, std::size_t index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

std::string Check::show(float value) { return format("%.9g", value); }
std::string Check::show(double value) { return format("%.17g", value); }

void Check::refuse(const std::string& what) const {
  std::string part = part_ ? part_ : "";
  if (index_ != no_index) part = at(part_, index_);
  throw InputError(where_, part.empty() ? what : part + ": " + what);
}

}  // namespace artu::traces
