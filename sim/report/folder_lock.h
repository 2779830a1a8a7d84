// Who works on a folder, known to other processes.
#pragma once

#include <string>

namespace artu::sim {

/// An advisory lock (flock) on a folder, for as long as this object or a process that was forked meanwhile lives: none
/// is left behind by a process that is killed.  The folder may be renamed or removed under it.
class FolderLock {
 public:
  /// Tries once.  Throws InputError where the folder cannot be opened.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// False: another process has it.  True as well on a file system without locks, which keeps nobody away.
  bool held() const { return held_; }

 private:
  int fd_;
  bool held_;
};

}  // namespace artu::sim
