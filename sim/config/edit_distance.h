// How far two names are apart, for "did you mean".
#pragma once

#include <cstddef>
#include <string>

namespace artu::sim {

/// Insertions, deletions and replacements of one character, and swaps of two neighbours (optimal string alignment).
std::size_t edit_distance(const std::string& a, const std::string& b);

/// Whether one may be the other, misspelt: at most a third of the longer is to be changed.
bool resembles(const std::string& a, const std::string& b);

}  // namespace artu::sim
