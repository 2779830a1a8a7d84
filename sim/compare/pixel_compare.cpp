#include "sim/compare/pixel_compare.h"

#include <fmt/format.h>

#include <cstring>

#include "sim/report/names.h"

namespace artu::sim {
namespace {

// The two rooms declare the same enumerations on their own; a number means the same in both.
static_assert(int(hw::HitClass::none) == int(ref::HitClass::none) &&
              int(hw::HitClass::miss) == int(ref::HitClass::miss));
static_assert(int(hw::HitClass::static_geometry) == int(ref::HitClass::static_geometry));
static_assert(int(hw::HitClass::dynamic_geometry) == int(ref::HitClass::dynamic_geometry));
static_assert(int(hw::Decision::sampled) == int(ref::Decision::sampled));
static_assert(int(hw::Decision::interpolated) == int(ref::Decision::interpolated));
static_assert(int(hw::Decision::traced) == int(ref::Decision::traced));

int times_written(const ref::Pixel&) { return 1; }
int times_written(const hw::PixelRecord& unit) { return unit.written; }

std::string t_text(std::uint32_t bits) {
  float t;
  std::memcpy(&t, &bits, sizeof t);
  return fmt::format("{} ({:#010x} = {})", bits, bits, t);
}

template <class Record>
std::string text_of(PixelField field, const Record& p) {
  switch (field) {
    case PixelField::color:
      return fmt::format("{} {} {}", p.r, p.g, p.b);
    case PixelField::hit_class:
      return class_name(static_cast<hw::HitClass>(p.hit_class));
    case PixelField::n_static:
      return fmt::format("{}", p.n_static);
    case PixelField::n_dynamic:
      return fmt::format("{}", p.n_dynamic);
    case PixelField::threshold:
      return fmt::format("{}", p.threshold);
    case PixelField::difference:
      return fmt::format("{}", p.difference);
    case PixelField::decision:
      return decision_name(static_cast<hw::Decision>(p.decision));
    case PixelField::pass:
      return fmt::format("{}", p.pass);
    case PixelField::t_bits:
      return t_text(p.t_bits);
    case PixelField::primitive:
      return fmt::format("{}", p.primitive);
    case PixelField::written:
      return fmt::format("{}", times_written(p));
  }
  return "";
}

}  // namespace

const char* field_name(PixelField field) {
  static constexpr const char* names[pixel_field_count] = {"colour",    "class",      "n_static", "n_dynamic",
                                                           "threshold", "difference", "decision", "pass",
                                                           "t_bits",    "primitive",  "written"};
  return names[static_cast<std::size_t>(field)];
}

std::string field_text(PixelField field, const ref::Pixel& golden) { return text_of(field, golden); }
std::string field_text(PixelField field, const hw::PixelRecord& unit) { return text_of(field, unit); }

PixelFields differing_fields(const ref::Pixel& golden, const hw::PixelRecord& unit) {
  PixelFields fields;
  const auto differs = [&](PixelField field, bool value) { fields.set(static_cast<std::size_t>(field), value); };
  differs(PixelField::color, golden.r != unit.r || golden.g != unit.g || golden.b != unit.b);
  differs(PixelField::hit_class, int(golden.hit_class) != int(unit.hit_class));
  differs(PixelField::n_static, golden.n_static != unit.n_static);
  differs(PixelField::n_dynamic, golden.n_dynamic != unit.n_dynamic);
  differs(PixelField::threshold, golden.threshold != unit.threshold);
  differs(PixelField::difference, golden.difference != unit.difference);
  differs(PixelField::decision, int(golden.decision) != int(unit.decision));
  differs(PixelField::pass, golden.pass != unit.pass);
  differs(PixelField::t_bits, golden.t_bits != unit.t_bits);
  differs(PixelField::primitive, golden.primitive != unit.primitive);
  differs(PixelField::written, unit.written != 1);
  return fields;
}

std::string comparison_table(const ref::Pixel& golden, const hw::PixelRecord& unit) {
  const PixelFields fields = differing_fields(golden, unit);
  std::string out = fmt::format("  {:<12}{:<34}{}\n", "", "unit", "golden");
  for (std::size_t i = 0; i < pixel_field_count; ++i) {
    const auto field = static_cast<PixelField>(i);
    out += fmt::format("{} {:<12}{:<34}{}\n", fields[i] ? '*' : ' ', field_name(field), field_text(field, unit),
                       field_text(field, golden));
  }
  return out;
}

}  // namespace artu::sim
