// How values and ranges are written, in files, lists and messages alike.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/fabric/parameter.h"

namespace artu::sim {

std::string range_text(const hw::IntegerRange& range);
std::string range_text(const hw::RealRange& range);
std::string range_text(const std::vector<const char*>& names);

/// As TOML; `real` keeps every bit of a binary32.
std::string integer_text(std::uint32_t value);
std::string real_text(float value);
std::string flag_text(bool value);
std::string choice_text(const char* name);
std::string table_text(hw::TableValues values);

}  // namespace artu::sim
