// One pixel of the unit against the same pixel of the golden model: pure functions of two records.
#pragma once

#include <bitset>
#include <cstddef>
#include <string>

#include "hw/pixel_record.h"
#include "ref/golden.h"

namespace artu::sim {

/// In the order of reports.
enum class PixelField {
  color,
  hit_class,
  n_static,
  n_dynamic,
  threshold,
  difference,
  decision,
  pass,
  t_bits,
  primitive,
  written
};
constexpr std::size_t pixel_field_count = 11;
using PixelFields = std::bitset<pixel_field_count>;

/// As in docs/selective-rendering.md where it is a column there; "colour" for r, g, b.
const char* field_name(PixelField field);

/// The value as text, for a reader.
std::string field_text(PixelField field, const ref::Pixel& golden);
std::string field_text(PixelField field, const hw::PixelRecord& unit);

/// The fields in which the two differ; `written` differs where the unit did not write the pixel exactly once.
PixelFields differing_fields(const ref::Pixel& golden, const hw::PixelRecord& unit);

/// All fields of both, a row a field, those that differ marked.
std::string comparison_table(const ref::Pixel& golden, const hw::PixelRecord& unit);

}  // namespace artu::sim
