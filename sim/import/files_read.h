// Which files a scene is made of: a glTF file names buffers and pictures, an OBJ file materials, a stage other scenes.
#pragma once

#include <set>
#include <string>

namespace artu::sim {

/// Notes, while it lives, every file that read_file() reads in this thread; one that is made meanwhile takes over.
class FilesRead {
 public:
  FilesRead();
  ~FilesRead();
  FilesRead(const FilesRead&) = delete;
  FilesRead& operator=(const FilesRead&) = delete;
  /// Real paths.
  const std::set<std::string>& paths() const { return paths_; }

  /// For read_file().
  static void note(const std::string& path);

 private:
  FilesRead* const outer_;
  std::set<std::string> paths_;
};

}  // namespace artu::sim
