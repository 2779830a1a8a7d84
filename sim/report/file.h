// Files that are written whole or not at all, and errors that name them.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "sim/report/interruption.h"
#include "traces/error.h"

namespace artu::sim {

/// Every failure (no permission, disk full) is a FileError with the file's name.
class OutputFile {
 public:
  explicit OutputFile(const std::string& name);
  /// The file is open already; below 0: errno says why it is not.
  OutputFile(const std::string& name, int descriptor);
  void write(std::string_view text);
  void flush();
  void close();  // a file that was neither flushed nor closed may lack its end
  const std::string& name() const { return name_; }

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  [[noreturn]] void fail() const;

  std::string name_;
  std::unique_ptr<std::FILE, Closer> file_;
};

/// Writes NAME.partial and renames it at close(); without close() nothing is left.
class AtomicFile {
 public:
  /// Refuses a file that exists, unless `force`, and one that another process writes.
  AtomicFile(const std::string& name, bool force);
  ~AtomicFile();
  void write(std::string_view text) { file_->write(text); }
  void close();

 private:
  std::string name_;
  RemoveOnInterrupt guard_;
  std::unique_ptr<OutputFile> file_;
};

/// Throws InputError if `name` exists already and `force` is not given, or it is no regular file.
void refuse_existing(const std::string& name, bool force);

/// Throws InputError if `name` is there and is no regular file: a pipe may wait for ever, a device may never end.
void refuse_irregular(const std::string& name);

/// What the standard library says of a file, with its name.
FileError file_error_of(const std::filesystem::filesystem_error& error);

void write_file(const std::string& name, std::string_view text);
std::string read_file(const std::string& name);

}  // namespace artu::sim
