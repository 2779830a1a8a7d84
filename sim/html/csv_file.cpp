#include "sim/html/csv_file.h"

#include <fmt/format.h>

#include <set>

#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file), text_(read_file(file)) {}

  bool at_end() const { return at_ == text_.size(); }
  std::size_t line() const { return line_; }

  /// The cells of a row, which may go over several lines.
  std::vector<std::string> row() {
    std::vector<std::string> cells(1);
    for (; at_ != text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') {
        quoted(cells.back());
      } else if (c == ',') {
        cells.emplace_back();
      } else if (c == '\n') {
        ++at_;
        ++line_;
        break;
      } else if (c != '\r') {
        cells.back() += c;
      }
    }
    return cells;
  }

  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw InputError(fmt::format("{}:{}", file_, line), what);
  }

 private:
  void quoted(std::string& cell) {
    const std::size_t begin = line_;
    for (++at_; at_ != text_.size(); ++at_) {
      if (text_[at_] == '\n') ++line_;
      if (text_[at_] != '"') {
        cell += text_[at_];
      } else if (at_ + 1 != text_.size() && text_[at_ + 1] == '"') {
        cell += text_[++at_];
      } else {
        return;
      }
    }
    fail(begin, "a quote does not end; another one would be right");
  }

  const std::string file_, text_;
  std::size_t at_ = 0, line_ = 1;
};

}  // namespace

CsvFile read_csv(const std::string& file) {
  Reader reader(file);
  CsvFile csv;
  csv.columns = reader.row();
  std::set<std::string> seen;
  for (const std::string& column : csv.columns) {
    if (!seen.insert(column).second) reader.fail(1, "column \"" + column + "\" comes twice; once would be right");
  }
  while (!reader.at_end()) {
    const std::size_t line = reader.line();
    csv.rows.push_back(reader.row());
    if (csv.rows.back().size() != csv.columns.size()) {
      reader.fail(line, fmt::format("has {} cells; {}, as the first line has, would be right", csv.rows.back().size(),
                                    csv.columns.size()));
    }
  }
  return csv;
}

}  // namespace artu::sim
