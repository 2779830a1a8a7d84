// Files as the trace needs them: all or nothing on writing, positioned reads on reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace artu::traces {

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
  int get() const { return fd_; }
  int release();

 private:
  int fd_;
};

/// Opens a file for writing, empty, and locks it until it is closed: a second process would write between our lines.
/// A file that nobody writes is what a killed process has left, and is taken.  Throws InputError while another process
/// writes it; -1, with errno, if it cannot be opened.
int open_locked(const std::string& path);

/// Writes PATH.partial, which becomes PATH at commit() and vanishes without it.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  void write(const void* data, std::size_t size);
  void commit();

 private:
  [[noreturn]] void fail(const std::string& doing, int error) const;

  std::string path_, partial_;
  bool committed_ = false;
  Descriptor fd_;
};

/// A regular file.  Reads by position and not by memory mapping: a file that shrinks meanwhile is an
/// error to report and not a signal.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }
  /// Up to `size` bytes from `offset`; fewer only at the end of the file.
  std::size_t read(std::uint64_t offset, void* data, std::size_t size) const;

 private:
  std::string path_;
  Descriptor fd_;
  std::uint64_t size_ = 0;
};

}  // namespace artu::traces
