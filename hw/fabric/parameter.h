// A parameter is declared once, in its block's config struct: name, default, unit, range, text.
//
// A config struct has plain fields with their defaults and `visit(ParameterVisitor&)`, which names each
// field.  Whoever reads a file, writes one or prints the list implements the visitor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace artu::hw {

struct IntegerRange {
  std::uint32_t minimum, maximum;
  bool power_of_two = false;
};

struct RealRange {
  double minimum, maximum;
};

/// The values of a table parameter, wherever they are kept.
struct TableValues {
  std::uint32_t* first;
  std::size_t size;
  std::uint32_t* begin() const { return first; }
  std::uint32_t* end() const { return first + size; }
};

class ParameterVisitor {
 public:
  virtual ~ParameterVisitor() = default;

  /// Parameters between enter and leave have the dotted prefix `group.`.
  virtual void enter(const char* group, const char* text) = 0;
  virtual void leave() = 0;

  /// `unit` is "" for pure numbers; ranges are inclusive.
  virtual void integer(const char* name, std::uint32_t& value, IntegerRange range, const char* unit,
                       const char* text) = 0;
  virtual void real(const char* name, float& value, RealRange range, const char* unit, const char* text) = 0;
  virtual void flag(const char* name, bool& value, const char* text) = 0;
  virtual void table(const char* name, TableValues values, IntegerRange range, const char* unit, const char* text) = 0;
  virtual void choice(const char* name, unsigned& value, const std::vector<const char*>& names, const char* text) = 0;

  template <std::size_t n>
  void table(const char* name, std::array<std::uint32_t, n>& values, IntegerRange range, const char* unit,
             const char* text) {
    table(name, TableValues{values.data(), n}, range, unit, text);
  }

  /// An enumeration whose values are 0, 1, ... in the order of `names`.
  template <class Enum>
  void choice(const char* name, Enum& value, std::initializer_list<const char*> names, const char* text) {
    auto number = static_cast<unsigned>(value);
    choice(name, number, std::vector<const char*>(names), text);
    value = static_cast<Enum>(number);
  }
};

}  // namespace artu::hw
