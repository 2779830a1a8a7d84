// The files of sim/html/assets, which the build makes part of the program: reports are one file and need no other.
#pragma once

#include <string_view>

namespace artu::sim {

/// Its text by its name, "report.css"; "" where there is none.
std::string_view html_asset(std::string_view name);

}  // namespace artu::sim
