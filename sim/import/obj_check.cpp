#include "sim/import/obj_check.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>

#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr std::string_view blanks = " \t\r";

/// The next word of the line, which is cut off it; empty at its end.
std::string_view next_word(std::string_view& line) {
  const std::size_t begin = line.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return line = {};
  line.remove_prefix(begin);
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

bool is_finite_number(std::string_view word) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // Beyond binary64's range: too large is not finite, too small is 0, and its digits tell which.
  if (error == std::errc::result_out_of_range) return word.find("e-") != word.npos || word.find("E-") != word.npos;
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

/// How many numbers a line with this keyword must have; 0 for other lines.
std::size_t numbers_of(std::string_view keyword) {
  if (keyword == "v" || keyword == "vn") return 3;
  return keyword == "vt" ? 1 : 0;
}

}  // namespace

void check_obj_numbers(std::string_view text, const std::string& path) {
  std::uint64_t number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const std::string_view keyword = next_word(line);
    const std::size_t needed = numbers_of(keyword);
    if (needed == 0) continue;
    std::size_t found = 0;
    for (std::string_view word = next_word(line); !word.empty() && word[0] != '#'; word = next_word(line), ++found) {
      if (is_finite_number(word)) continue;
      throw InputError(fmt::format("{}:{}", path, number),
                       fmt::format("\"{} ... {}\": a finite number would be right", keyword, word.substr(0, 40)));
    }
    if (found >= needed) continue;
    throw InputError(fmt::format("{}:{}", path, number),
                     fmt::format("\"{}\" with {} numbers; at least {} would be right", keyword, found, needed));
  }
}

}  // namespace artu::sim
