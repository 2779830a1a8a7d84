#include "end_to_end/program.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

namespace artu::test {
namespace fs = std::filesystem;
namespace {

std::string read_all(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

std::string repeatable(const std::string& name, const std::string& text) {
  if (name.size() > 5 && name.compare(name.size() - 5, 5, ".json") == 0) {
    nlohmann::json json = nlohmann::json::parse(text);
    for (const char* key : {"simulation", "command"}) json.erase(key);
    return json.dump(1);
  }
  if (name != "stats.txt") return text;
  std::istringstream in(text);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, 11, "simulation.") != 0) out += line + "\n";
  }
  return out;
}

ProgramTest::ProgramTest() {
  std::string name = (fs::path(::testing::TempDir()) / "artu_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no folder for the test");
  folder_ = name;
}

ProgramTest::~ProgramTest() {
  processes_.end();
  // What was started by what was killed may take a moment to end, and put another file there.
  std::error_code error;
  for (int attempt = 0; attempt < 10; ++attempt) {
    fs::remove_all(folder_, error);
    if (!error) break;
  }
}

Finished ProgramTest::artu(const std::vector<std::string>& args) const { return program(ARTU_BINARY, args); }

Finished ProgramTest::program(const std::string& binary, const std::vector<std::string>& args) const {
  const std::string out = folder_.string() + ".out", err = folder_.string() + ".err";
  const int code = processes_.start(binary, args, folder_.string(), out, err).wait();
  Finished finished{code, read_all(out), read_all(err)};
  fs::remove(out);
  fs::remove(err);
  return finished;
}

Running ProgramTest::start(const std::vector<std::string>& args, const std::string& err) const {
  return start_program(ARTU_BINARY, args, err);
}

Running ProgramTest::start_program(const std::string& binary, const std::vector<std::string>& args,
                                   const std::string& err) const {
  return processes_.start(binary, args, folder_.string(), "/dev/null", (folder_ / err).string());
}

Finished ProgramTest::fine(const std::vector<std::string>& args) const {
  Finished finished = artu(args);
  EXPECT_EQ(finished.code, 0) << finished.out << finished.err;
  return finished;
}

std::string ProgramTest::refused(const std::vector<std::string>& args) const {
  const Finished finished = artu(args);
  EXPECT_EQ(finished.code, 2) << finished.out << finished.err;
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.err.compare(0, 7, "error: "), 0) << finished.err;
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  return finished.err;
}

void ProgramTest::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string ProgramTest::read(const std::string& name) const {
  EXPECT_TRUE(exists(name)) << name;
  return read_all(folder_ / name);
}

std::vector<std::vector<std::string>> ProgramTest::csv(const std::string& name) const {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(read(name));
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

std::vector<std::string> ProgramTest::content(const std::string& name) const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_ / name)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void ProgramTest::write_scene(const std::string& name) const {
  write(name,
        "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 1 0\n"
        "f 1 2 3\nf 1 3 4\nf 1 2 5\n");
}

}  // namespace artu::test
