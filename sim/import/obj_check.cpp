#include "sim/import/obj_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr std::string_view blanks = " \t";

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

struct Index {
  std::string_view written;
  std::int64_t value = 0;  // of one too long for 64 bits the largest or smallest there is: no file has as many lines
};

/// An integer that is cut off the front of the word; nothing if it does not begin with one.
std::optional<Index> cut_index(std::string_view& word) {
  Index index{word};
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const char *const begin = word.data() + (plus ? 1 : 0), *const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(begin, last, index.value);
  if (error == std::errc::invalid_argument) return std::nullopt;
  using Limits = std::numeric_limits<std::int64_t>;
  if (error == std::errc::result_out_of_range) index.value = word[0] == '-' ? Limits::min() : Limits::max();
  index.written = word.substr(0, static_cast<std::size_t>(end - word.data()));
  word.remove_prefix(index.written.size());
  return index;
}

/// What a line gives, and corners name by their places in the file.
struct Kind {
  std::string_view keyword;
  const char* name;
  std::size_t least;       // numbers of a line
  std::int64_t count = 0;  // lines so far
  Index needed{};          // the largest place that was named
  std::uint64_t line = 0;  // where
};

class ObjCheck {
 public:
  explicit ObjCheck(const std::string& path) : path_(path) {}

  void line(std::string_view line) {
    ++line_;
    const std::string_view keyword = next_word(line);
    if (keyword == "f") face(line);
    for (Kind& kind : kinds_) {
      if (keyword == kind.keyword) numbers(line, kind);
    }
  }

  /// A face may come before its corners.
  std::uint64_t finish() {
    for (const Kind& kind : kinds_) {
      if (kind.needed.value > kind.count) missing(kind, kind.needed, kind.line);
    }
    return triangles_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { fail(what, line_); }
  [[noreturn]] void fail(const std::string& what, std::uint64_t line) const {
    throw InputError(fmt::format("{}:{}", path_, line), what);
  }

  void numbers(std::string_view line, Kind& kind) const {
    std::size_t found = 0;
    for (std::string_view word = next_word(line); !word.empty() && word[0] != '#'; word = next_word(line), ++found) {
      if (is_finite_number(word)) continue;
      fail(fmt::format("\"{} ... {}\": a finite number would be right", kind.keyword, word.substr(0, 40)));
    }
    if (found < kind.least) {
      fail(fmt::format("\"{}\" with {} numbers; at least {} would be right", kind.keyword, found, kind.least));
    }
    ++kind.count;
  }

  void face(std::string_view line) {
    std::uint64_t corners = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line), ++corners) corner(word);
    if (corners < 3) fail(fmt::format("a face of {} corners; at least 3 would be right", corners));
    triangles_ += corners - 2;
  }

  /// V, V/T, V//N or V/T/N.
  void corner(std::string_view word) {
    std::array<std::optional<Index>, 3> indices;
    std::string_view rest = word;
    std::size_t part = 0;
    for (;; ++part, rest.remove_prefix(1)) {
      const bool left_out = part == 1 && rest.substr(0, 1) == "/";
      if (!left_out) indices[part] = cut_index(rest);
      const bool wrong = !left_out && !indices[part];
      if (wrong || (!rest.empty() && (rest[0] != '/' || part == 2))) {
        fail(fmt::format("\"f ... {}\": integers as in 1, 1/2, 1//3 or 1/2/3 would be right", word.substr(0, 40)));
      }
      if (rest.empty()) break;
    }
    for (part = 0; part < indices.size(); ++part) {
      if (indices[part]) use(kinds_[part], *indices[part]);
    }
  }

  /// Those below 0 count back from the last one so far.
  void use(Kind& kind, const Index& index) const {
    if (index.value == 0 || index.value < -kind.count) missing(kind, index, line_);
    if (index.value <= kind.needed.value) return;
    kind.needed = index;
    kind.line = line_;
  }

  [[noreturn]] void missing(const Kind& kind, const Index& index, std::uint64_t line) const {
    const std::string right = kind.count == 0 ? "a file that has it" : fmt::format("1 ... {}", kind.count);
    fail(fmt::format("a face uses {} {} of {}; {} would be right", kind.name, index.written.substr(0, 40), kind.count,
                     right),
         line);
  }

  const std::string& path_;
  // In the order of a corner's parts.
  std::array<Kind, 3> kinds_{{{"v", "vertex", 3}, {"vt", "texture coordinate", 1}, {"vn", "normal", 3}}};
  std::uint64_t line_ = 0, triangles_ = 0;
};

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return text.substr(text.substr(0, mark.size()) == mark ? mark.size() : 0);
}

std::uint64_t check_obj(std::string_view text, const std::string& path) {
  ObjCheck check(path);
  while (!text.empty()) {
    // As tinyobjloader: a line ends with \n, \r\n, or, on old machines, \r.
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    check.line(text.substr(0, end));
    text.remove_prefix(std::min(end + (text.substr(end, 2) == "\r\n" ? 2 : 1), text.size()));
  }
  return check.finish();
}

}  // namespace artu::sim
