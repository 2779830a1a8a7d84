#include "sim/report/run_folder.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

/// Only what `artu run` made may be replaced.
bool is_run_folder(const std::string& name) {
  std::error_code error;
  return fs::is_directory(name, error) && (fs::exists(name + "/manifest.json", error) || fs::is_empty(name, error));
}

/// "scenes/default.stage.toml" -> "default"
std::string scene_name(const std::string& scene_file) {
  std::string name = fs::path(scene_file).filename().string();
  name = name.substr(0, name.find('.', 1));
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '_';
  }
  return name;
}

[[noreturn]] void fail(const std::string& name, const std::error_code& error) {
  throw FileError(name, "cannot write: " + error.message() + "; another folder with -o would be right");
}

}  // namespace

// Delegates, so that the destructor runs, and removes what was made, if the rest throws.
RunFolder::RunFolder(const std::string& name, bool force) : RunFolder() {
  name_ = name;
  force_ = force;
  while (name_.size() > 1 && name_.back() == '/') name_.pop_back();
  std::error_code error;
  if (fs::exists(name_, error)) {
    if (!force) throw InputError(name_, "exists already; another folder, or --force, would be right");
    if (!is_run_folder(name_)) {
      throw InputError(name_,
                       "exists and is not the folder of a run, so --force does not replace it; another folder "
                       "would be right");
    }
  }
  create_parent();
  if (force) fs::remove_all(partial(), error);
  if (!create_partial()) {
    throw InputError(partial(), "exists: another run writes it, or one was killed; --force would replace it");
  }
}

RunFolder RunFolder::next_free(const std::string& scene_file) {
  RunFolder folder;
  const std::string base = "runs/" + scene_name(scene_file) + "-";
  for (unsigned n = 1;; ++n) {
    folder.name_ = fmt::format("{}{}", base, n);
    if (n == 1) folder.create_parent();
    std::error_code error;
    if (!fs::exists(folder.name_, error) && folder.create_partial()) return folder;
  }
}

RunFolder::RunFolder(RunFolder&& other) noexcept
    : name_(std::move(other.name_)),
      force_(other.force_),
      open_(other.open_),
      guard_(std::move(other.guard_)),
      created_(std::move(other.created_)) {
  other.open_ = false;
  other.created_.clear();
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  if (open_) fs::remove_all(partial(), ignored);
  for (auto parent = created_.rbegin(); parent != created_.rend(); ++parent) fs::remove(*parent, ignored);
}

void RunFolder::create_parent() {
  fs::path parent;
  for (const fs::path& part : fs::path(name_).parent_path()) {
    parent /= part;
    std::error_code error;
    if (fs::create_directory(parent, error)) created_.push_back(parent.string());
    if (error) fail(parent.string(), error);
  }
}

bool RunFolder::create_partial() {
  std::error_code error;
  open_ = fs::create_directory(partial(), error);
  if (error) fail(partial(), error);
  if (open_) guard_ = std::make_unique<RemoveOnInterrupt>(partial());
  return open_;
}

void RunFolder::commit() {
  std::error_code error;
  const std::string old = name_ + ".replaced";
  const bool replace = force_ && fs::exists(name_, error);
  if (replace) fs::rename(name_, old, error);
  if (!error) fs::rename(partial(), name_, error);
  if (error) fail(name_, error);
  open_ = false;
  created_.clear();
  guard_.reset();
  if (replace) fs::remove_all(old, error);
}

}  // namespace artu::sim
