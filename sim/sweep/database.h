// The table of a sweep as an SQLite database.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

struct sqlite3;

namespace artu::sim {

struct SweepTable;

struct Counter {
  std::uint32_t point = 0;
  std::string block, name;
  nlohmann::ordered_json value;
};

class Database {
 public:
  /// Makes the file anew.  Every failure is an InputError with its name.
  explicit Database(const std::string& file);
  /// Table `points`: columns of whole numbers are INTEGER, of other numbers REAL, else TEXT.
  void add_points(const SweepTable& table);
  /// Table `counters`: point, block, counter, value.
  void add_counters(const std::vector<Counter>& counters);
  void close();

 private:
  struct Closer {
    void operator()(sqlite3* database) const;
  };
  void execute(const std::string& sql);
  void insert(const std::string& sql, const std::vector<std::vector<nlohmann::ordered_json>>& rows);
  [[noreturn]] void fail() const;

  const std::string file_;
  std::unique_ptr<sqlite3, Closer> database_;
};

}  // namespace artu::sim
