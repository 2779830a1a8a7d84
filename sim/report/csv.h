// Comma-separated values as RFC 4180 has them.
#pragma once

#include <string>

namespace artu::sim {

/// The text, in quotation marks where it holds a comma, a quotation mark or a line break.
std::string csv_field(const std::string& text);

}  // namespace artu::sim
