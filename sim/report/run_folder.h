// The folder of a run: complete under its name, or not there at all.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/report/folder_lock.h"
#include "sim/report/interruption.h"

namespace artu::sim {

/// Files go into NAME.partial, which commit() renames; without commit() nothing is left behind.
class RunFolder {
 public:
  /// Refuses a folder that exists.  With `force` an earlier run's folder is replaced at commit(), nothing else is.
  RunFolder(const std::string& name, bool force);
  /// `runs/<scene>-<n>` with the first free n; runs at the same time get different ones.
  static RunFolder next_free(const std::string& scene_file);
  RunFolder(RunFolder&& other) noexcept;
  ~RunFolder();

  const std::string& name() const { return name_; }
  std::string partial() const { return name_ + ".partial"; }
  /// Where to write a file of this name.
  std::string file(const std::string& name) const { return partial() + "/" + name; }
  void commit();

 private:
  RunFolder() = default;
  void create_parent();
  void remove_left_over() const;
  bool create_partial();  // false: exists

  std::string name_;
  bool force_ = false;
  bool open_ = false;
  std::unique_ptr<RemoveOnInterrupt> guard_;
  std::unique_ptr<FolderLock> lock_;
  std::vector<std::string> created_;  // parents that we made, outermost first
};

}  // namespace artu::sim
