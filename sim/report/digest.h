// What identifies an input file in the manifest.
#pragma once

#include <string>
#include <string_view>

namespace artu::sim {

/// 64 hexadecimal digits, as `sha256sum` prints them.  Throws InputError if the file cannot be read.
std::string sha256_of_file(const std::string& file);
/// The same of a text.
std::string sha256_of(std::string_view text);

}  // namespace artu::sim
