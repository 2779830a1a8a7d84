#include "sim/report/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cctype>
#include <cstdio>
#include <filesystem>

#include "sim/report/guarded_folder.h"
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

/// Both at once, so that there is a whole folder under the name at any moment; false where the file system cannot.
bool exchange(const std::string& a, const std::string& b) {
  return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

[[noreturn]] void fail(const std::string& name, const std::error_code& error) {
  throw FileError(name, "cannot write: " + error.message() + "; another folder with -o would be right");
}

[[noreturn]] void refuse_other_run(const std::string& partial) {
  throw InputError(partial, "another run writes it; another folder would be right, or to wait until it has ended");
}

/// Returns its new name.
std::string put_aside(const std::string& folder) {
  const std::string aside = folder + ".replaced";
  std::error_code error;
  if (is_run_folder(aside)) fs::remove_all(aside, error);  // a run that was killed has left it
  fs::rename(folder, aside, error);
  if (error)
    throw InputError(aside, "is in the way of --force: " + error.message() + "; another name of it would be right");
  return aside;
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
  if (force) remove_left_over();
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
      lock_(std::move(other.lock_)),
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

/// Of a run that was killed; not of one that is still at work.
void RunFolder::remove_left_over() const {
  std::error_code error;
  if (!fs::is_directory(partial(), error)) return;
  const FolderLock lock(partial());
  if (!lock.held()) refuse_other_run(partial());
  fs::remove_all(partial(), error);
}

bool RunFolder::create_partial() {
  std::error_code error;
  guard_ = make_guarded_folder(partial(), error);
  if (error) fail(partial(), error);
  if (!guard_) return false;
  lock_ = std::make_unique<FolderLock>(partial());
  if (!lock_->held()) {  // one with --force has come between
    guard_.reset();
    refuse_other_run(partial());
  }
  return open_ = true;
}

void RunFolder::commit() {
  std::error_code error;
  const bool replace = force_ && fs::exists(name_, error);
  std::string old;
  std::unique_ptr<FolderLock> old_lock;  // or another --force would take it for what a killed run has left
  if (replace) old_lock = std::make_unique<FolderLock>(name_);
  if (replace && exchange(partial(), name_)) {
    old = partial();  // still guarded
  } else {
    if (replace) old = put_aside(name_);
    fs::rename(partial(), name_, error);
    if (error) fail(name_, error);
  }
  open_ = false;
  created_.clear();
  if (replace) fs::remove_all(old, error);
  guard_.reset();
  lock_.reset();
}

}  // namespace artu::sim
