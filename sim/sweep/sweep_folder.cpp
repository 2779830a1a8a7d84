#include "sim/sweep/sweep_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "sim/html/json_file.h"
#include "sim/report/durable.h"
#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

constexpr const char* description_file = "sweep.json";

std::string without_slashes(std::string name) {
  while (name.size() > 1 && name.back() == '/') name.pop_back();
  return name;
}

void make_folder(const std::string& name) {
  std::error_code error;
  fs::create_directories(name, error);
  if (error) throw InputError(name, "cannot write: " + error.message() + "; another folder with -o would be right");
}

/// One word for this process among all that may work on the same file system.
std::string own_name() {
  std::array<char, 256> host{};
  if (gethostname(host.data(), host.size() - 1) != 0) host = {"host"};
  return fmt::format("{}-{}", host.data(), getpid());
}

std::string shortened(const nlohmann::ordered_json& value) {
  std::string text = value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  return text.size() > 80 ? text.substr(0, 77) + "..." : text;
}

/// Only what killed processes leave before sweep.json is there.
bool is_begun(const std::string& name) {
  for (const auto& entry : fs::directory_iterator(name)) {
    if (entry.path().filename() != std::string(description_file) + ".partial") return false;
  }
  return true;
}

}  // namespace

void check_sweep_folder(const std::string& given, SweepFolder::Begin begin) {
  using Begin = SweepFolder::Begin;
  const std::string name = without_slashes(given);
  std::error_code error;
  const bool there = fs::exists(name, error), known = fs::exists(name + "/" + description_file, error);
  if (begin == Begin::take_part && !known) {
    throw InputError(name, "is not the folder of a sweep; that of one that has begun would be right");
  }
  if (!there) return;
  if (begin == Begin::fresh) {
    throw InputError(name, "exists already; another folder, --resume to go on, or --force, would be right");
  }
  if (!known && !(fs::is_directory(name, error) && is_begun(name))) {
    throw InputError(name, "exists and is not the folder of a sweep; another folder would be right");
  }
}

SweepFolder::SweepFolder(const std::string& name, const std::string& description, Begin begin)
    : name_(without_slashes(name)) {
  check_sweep_folder(name_, begin);
  std::error_code error;
  make_folder(name_);
  if (begin != Begin::take_part) lock();
  if (begin == Begin::replace) {
    if (others_work()) {
      throw InputError(name_, "another artu sweep --part works on it; when that has ended, --force would be right");
    }
    for (const auto& entry : fs::directory_iterator(name_)) fs::remove_all(entry.path(), error);
  }
  if (fs::exists(file(description_file), error)) {
    compare(description);
  } else {
    write_durably(file(description_file), description);
  }
  make_folder(file("points"));
  work_ = file("points.partial/" + own_name());
  if (begin != Begin::take_part && begin != Begin::share) remove_unfinished();
  guard_ = std::make_unique<RemoveOnInterrupt>(work_);
  make_folder(work_);
  work_lock_ = std::make_unique<FolderLock>(work_);
}

SweepFolder::~SweepFolder() {
  guard_.reset();
  std::error_code ignored;
  fs::remove_all(work_, ignored);
  fs::remove(file("points.partial"), ignored);  // if no other process has its part there
}

/// The processes that simulate hold the lock as well: while one of a sweep that was killed still ends, we wait.
void SweepFolder::lock() {
  for (int attempt = 0; attempt < 100; ++attempt) {
    lock_ = std::make_unique<FolderLock>(name_);
    if (lock_->held()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  throw InputError(name_, "another artu sweep works on it; when that has ended, --resume would be right");
}

/// Processes with a part of the sweep.
bool SweepFolder::others_work() const {
  std::error_code error;
  for (const auto& part : fs::directory_iterator(file("points.partial"), error)) {
    if (part.is_directory(error) && !FolderLock(part.path().string()).held()) return true;
  }
  return false;
}

void SweepFolder::compare(const std::string& description) const {
  using Json = nlohmann::ordered_json;
  const std::string recorded = read_file(file(description_file));
  if (recorded == description) return;
  const Json ours = Json::parse(description), theirs = read_json(file(description_file));
  if (!theirs.is_object()) throw InputError(file(description_file), "is no JSON object; another folder would be right");
  const Json difference = Json::diff(theirs, ours);
  std::string what = "other bytes";
  if (!difference.empty()) {
    const std::string path = difference[0].at("path");
    const Json::json_pointer pointer(path);
    const auto at = [&pointer](const Json& json) {
      return json.contains(pointer) ? shortened(json.at(pointer)) : std::string("nothing");
    };
    what = fmt::format("{} is {} there and {} here", path.substr(1), at(theirs), at(ours));
  }
  throw InputError(
      file(description_file),
      fmt::format("is of another sweep: {}; the grid that it was begun with, or another folder, would be right", what));
}

bool SweepFolder::finished(const std::string& name) const {
  std::error_code error;
  return fs::exists(point(name), error);
}

void SweepFolder::remove_unfinished() const {
  std::error_code ignored;
  std::vector<fs::path> parts;
  for (const auto& part : fs::directory_iterator(file("points.partial"), ignored)) parts.push_back(part.path());
  for (const fs::path& part : parts) {
    if (fs::is_directory(part, ignored) && !FolderLock(part.string()).held()) continue;
    fs::remove_all(part, ignored);
  }
  fs::remove(file("points.partial"), ignored);  // if that was all
}

void SweepFolder::publish(const std::string& name) const {
  sync_folder(unfinished(name));
  std::error_code ignored;
  if (!rename_durably(unfinished(name), point(name))) fs::remove_all(unfinished(name), ignored);
}

}  // namespace artu::sim
