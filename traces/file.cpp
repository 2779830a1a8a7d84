#include "traces/file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "traces/error.h"

namespace artu::traces {

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

int Descriptor::release() { return std::exchange(fd_, -1); }

namespace {

bool is_the_file(int fd, const std::string& path) {
  struct stat ours {};
  struct stat there {};
  return ::fstat(fd, &ours) == 0 && ::stat(path.c_str(), &there) == 0 && ours.st_dev == there.st_dev &&
         ours.st_ino == there.st_ino;
}

}  // namespace

int open_locked(const std::string& path) {
  for (;;) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
    if (file.get() < 0) return -1;
    // Any other error is that of a file system without locks.
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      throw FileError(path, "another process writes it; another name would be right, or to wait until it has ended");
    }
    if (!is_the_file(file.get(), path)) continue;  // the other one has finished between our two steps
    // A device has no length.
    if (::ftruncate(file.get(), 0) != 0 && errno != EINVAL) return -1;
    return file.release();
  }
}

OutputFile::OutputFile(const std::string& path) : path_(path), partial_(path + ".partial"), fd_(open_locked(partial_)) {
  if (fd_.get() < 0) throw FileError(partial_, std::string("cannot create the file: ") + std::strerror(errno));
}

OutputFile::~OutputFile() {
  if (!committed_) ::unlink(partial_.c_str());
}

void OutputFile::fail(const std::string& doing, int error) const {
  throw FileError(partial_, "cannot " + doing + ": " + std::strerror(error));
}

void OutputFile::write(const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(fd_.get(), at, size);
    if (written < 0) {
      if (errno == EINTR) continue;
      fail("write the file", errno);
    }
    at += written;
    size -= static_cast<std::size_t>(written);
  }
}

void OutputFile::commit() {
  // The data is on the disk before the name is: a power cut leaves the old file or the new one.
  if (::fsync(fd_.get()) != 0 && errno != EINVAL && errno != EROFS) fail("write the file", errno);
  // Before it is closed: closing unlocks it, and somebody else would find a file that nobody writes.
  if (std::rename(partial_.c_str(), path_.c_str()) != 0) fail("rename the file to " + path_, errno);
  committed_ = true;
  if (::close(fd_.release()) != 0)
    throw FileError(path_, std::string("cannot write the file: ") + std::strerror(errno));
}

// Not blocking, or a named pipe would wait for a writer before it can be refused.
InputFile::InputFile(const std::string& path)
    : path_(path), fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  if (fd_.get() < 0) throw FileError(path, std::string("cannot open the file: ") + std::strerror(errno));
  struct stat status {};
  if (::fstat(fd_.get(), &status) != 0) {
    throw FileError(path, std::string("cannot read the file: ") + std::strerror(errno));
  }
  if (!S_ISREG(status.st_mode)) throw InputError(path, "is not a regular file; a trace on a disk would be right");
  size_ = static_cast<std::uint64_t>(status.st_size);
}

std::size_t InputFile::read(std::uint64_t offset, void* data, std::size_t size) const {
  char* at = static_cast<char*>(data);
  std::size_t total = 0;
  while (total < size) {
    const ssize_t got = ::pread(fd_.get(), at + total, size - total, static_cast<off_t>(offset + total));
    if (got < 0) {
      if (errno == EINTR) continue;
      throw FileError(path_, std::string("cannot read the file: ") + std::strerror(errno));
    }
    if (got == 0) break;
    total += static_cast<std::size_t>(got);
  }
  return total;
}

}  // namespace artu::traces
