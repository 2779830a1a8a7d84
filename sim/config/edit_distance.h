// How far two names are apart, for "did you mean".
#pragma once

#include <cstddef>
#include <string>

namespace artu::sim {

/// Levenshtein's: insertions, deletions and replacements of one character.
std::size_t edit_distance(const std::string& a, const std::string& b);

}  // namespace artu::sim
