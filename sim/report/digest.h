// What identifies an input file in the manifest.
#pragma once

#include <string>

namespace artu::sim {

/// 64 hexadecimal digits, as `sha256sum` prints them.  Throws InputError if the file cannot be read.
std::string sha256_of_file(const std::string& file);

}  // namespace artu::sim
