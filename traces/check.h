// The words of validate(): what is checked, and the InputError when it does not hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "traces/frame.h"

namespace artu::traces {

/// Checks the fields of one thing.  Nothing is formatted unless a check fails.
class Check {
 public:
  static constexpr const char* coordinate_range = "finite and below 2^62 in magnitude";

  explicit Check(const std::string& where) : where_(where) {}
  /// The same for a part of the thing.
  Check inside(const char* part) const { return Check(*this, part, no_index); }
  Check inside(const char* list, std::size_t index) const { return Check(*this, list, index); }

  void coordinate(const char* field, float value) const;
  void coordinate(const char* field, const Vec3& value) const;
  void weight(const char* field, const Vec3& value) const;
  void text(const char* field, const std::string& value) const;
  void side(const char* field, std::uint32_t value) const;
  void enumeration(const char* field, std::uint8_t value, const char* range) const;
  void at_most(const char* field, std::size_t value, std::size_t most) const;
  void size(const char* array, std::size_t size, std::size_t expected, const std::string& why) const;

  template <typename T>
  void that(bool holds, const char* field, T value, const std::string& range) const {
    if (!holds) fail(field, value, range);
  }

  template <typename T>
  [[noreturn]] void fail(const std::string& field, T value, const std::string& range) const {
    refuse(field + " is " + show(value) + "; must be " + range);
  }

  static std::string at(const char* array, std::size_t index);
  static std::string show(float value);
  static std::string show(double value);
  template <typename T>
  static std::string show(T value) {
    return std::to_string(value);
  }

 private:
  static constexpr std::size_t no_index = ~std::size_t{0};
  Check(const Check& outer, const char* part, std::size_t index) : where_(outer.where_), part_(part), index_(index) {}
  [[noreturn]] void refuse(const std::string& what) const;

  const std::string& where_;
  const char* part_ = nullptr;
  std::size_t index_ = no_index;
};

}  // namespace artu::traces
