#include "sim/report/durable.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const std::string& name) {
  throw FileError(name, std::string("cannot write: ") + std::strerror(errno) +
                            "; a folder that can be written, on a disk with room, would be right");
}

void sync_path(const std::string& name) {
  const int fd = open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) fail(name);
  const int result = fsync(fd), error = errno;
  close(fd);
  errno = error;
  if (result != 0 && error != EINVAL) fail(name);  // EINVAL: a file system that cannot
}

std::string parent_of(const std::string& name) {
  const fs::path parent = fs::path(name).parent_path();
  return parent.empty() ? "." : parent.string();
}

}  // namespace

void sync_folder(const std::string& folder) {
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    if (entry.is_regular_file() || entry.is_directory()) sync_path(entry.path().string());
  }
  sync_path(folder);
}

void write_durably(const std::string& name, std::string_view text) {
  const std::string partial = name + ".partial";
  write_file(partial, text);
  sync_path(partial);
  if (std::rename(partial.c_str(), name.c_str()) != 0) fail(name);
  sync_path(parent_of(name));
}

bool rename_durably(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) {
    if (errno == ENOTEMPTY || errno == EEXIST) return false;
    fail(to);
  }
  sync_path(parent_of(to));
  return true;
}

}  // namespace artu::sim
