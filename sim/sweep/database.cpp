#include "sim/sweep/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>

#include "sim/sweep/table.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

/// A name as SQL has it: paths hold dots.
std::string quoted(const std::string& name) {
  std::string out = "\"";
  for (const char c : name) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

const char* type_of(const SweepTable& table, std::size_t column) {
  bool numbers = true, integers = true;
  for (const auto& row : table.rows) {
    const Json& cell = row[column];
    if (cell.is_null()) continue;
    numbers = numbers && cell.is_number();
    integers = integers && cell.is_number_integer();
  }
  return !numbers ? "TEXT" : integers ? "INTEGER" : "REAL";
}

int bind(sqlite3_stmt* statement, int place, const Json& cell) {
  if (cell.is_null()) return sqlite3_bind_null(statement, place);
  if (cell.is_number_integer()) return sqlite3_bind_int64(statement, place, cell.get<sqlite3_int64>());
  if (cell.is_number()) return sqlite3_bind_double(statement, place, cell.get<double>());
  const std::string text = cell.is_string() ? cell.get<std::string>() : cell.dump();
  return sqlite3_bind_text(statement, place, text.c_str(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}

}  // namespace

void Database::Closer::operator()(sqlite3* database) const { sqlite3_close(database); }

Database::Database(const std::string& file) : file_(file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);  // of a process that was killed
  sqlite3* database = nullptr;
  const int result = sqlite3_open(file.c_str(), &database);
  database_.reset(database);
  if (result != SQLITE_OK) fail();
  // The file is renamed when it is whole: until then nobody reads it, and nothing need be rolled back.
  execute("PRAGMA journal_mode = OFF");
  execute("BEGIN");
  execute("CREATE TABLE counters (point INTEGER, block TEXT, counter TEXT, value INTEGER)");
}

void Database::fail() const {
  throw InputError(file_,
                   fmt::format("cannot write: {}; a folder that can be written, on a disk with room, would be right",
                               sqlite3_errmsg(database_.get())));
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void Database::insert(const std::string& sql, const std::vector<std::vector<Json>>& rows) {
  sqlite3_stmt* made = nullptr;
  if (sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &made, nullptr) != SQLITE_OK) fail();
  const std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement(made, sqlite3_finalize);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (bind(made, static_cast<int>(i) + 1, row[i]) != SQLITE_OK) fail();
    }
    if (sqlite3_step(made) != SQLITE_DONE || sqlite3_reset(made) != SQLITE_OK) fail();
  }
}

void Database::add_points(const SweepTable& table) {
  std::string columns, places;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    columns += fmt::format("{}{} {}", i == 0 ? "" : ", ", quoted(table.columns[i]), type_of(table, i));
    places += i == 0 ? "?" : ", ?";
  }
  execute("CREATE TABLE points (" + columns + ")");
  insert("INSERT INTO points VALUES (" + places + ")", table.rows);
}

void Database::add_counters(const std::vector<Counter>& counters) {
  std::vector<std::vector<Json>> rows;
  for (const Counter& c : counters) rows.push_back({c.point, c.block, c.name, c.value});
  insert("INSERT INTO counters VALUES (?, ?, ?, ?)", rows);
}

void Database::close() {
  execute("CREATE INDEX counters_of_point ON counters (point)");
  execute("COMMIT");
  if (sqlite3_close(database_.release()) != SQLITE_OK) throw InputError(file_, "cannot write");
}

}  // namespace artu::sim
