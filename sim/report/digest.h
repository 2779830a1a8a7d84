// What identifies an input file in the manifest.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace artu::sim {

/// 64 hexadecimal digits, as `sha256sum` prints them.  Throws InputError if the file cannot be read.
std::string sha256_of_file(const std::string& file);
/// Of an input that is made of several files: of what `sha256sum` prints of them all, the file itself first, the others
/// in the order of their names, seen from its folder. Of one file alone its own.
std::string sha256_of_files(const std::string& file, const std::set<std::string>& others);
/// The same of a text.
std::string sha256_of(std::string_view text);

}  // namespace artu::sim
