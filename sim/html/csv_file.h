// CSV files as RFC 4180 has them: quotes, and in quotes commas, line ends and doubled quotes.
#pragma once

#include <string>
#include <vector>

namespace artu::sim {

struct CsvFile {
  std::vector<std::string> columns;  // the first line
  std::vector<std::vector<std::string>> rows;
};

/// Throws InputError, with the line, where a row has more or fewer cells than the first line, a column comes twice, or
/// a quote does not end.
CsvFile read_csv(const std::string& file);

}  // namespace artu::sim
