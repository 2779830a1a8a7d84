#include "sim/import/files_read.h"

#include <filesystem>

namespace artu::sim {
namespace {

thread_local FilesRead* innermost = nullptr;

}  // namespace

FilesRead::FilesRead() : outer_(innermost) { innermost = this; }
FilesRead::~FilesRead() { innermost = outer_; }

void FilesRead::note(const std::string& path) {
  if (innermost != nullptr) innermost->paths_.insert(std::filesystem::canonical(path).string());
}

}  // namespace artu::sim
