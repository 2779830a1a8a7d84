#include "sim/report/file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "traces/error.h"
#include "traces/file.h"

namespace artu::sim {
namespace fs = std::filesystem;

OutputFile::OutputFile(const std::string& name) : name_(name), file_(std::fopen(name.c_str(), "wb")) {
  if (!file_) fail();
}

OutputFile::OutputFile(const std::string& name, int descriptor) : name_(name) {
  if (descriptor >= 0) file_.reset(fdopen(descriptor, "wb"));
  if (!file_) fail();
}

void OutputFile::fail() const {
  throw FileError(name_, std::string("cannot write: ") + std::strerror(errno) +
                             "; a folder that can be written, on a disk with room, would be right");
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
}

void OutputFile::flush() {
  if (std::fflush(file_.get()) != 0) fail();
}

void OutputFile::close() {
  if (std::fclose(file_.release()) != 0) fail();
}

void refuse_existing(const std::string& name, bool force) {
  std::error_code ignored;
  if (!fs::exists(name, ignored)) return;
  // Renaming a file onto a device or a folder would replace it, or fail: neither is what was meant.
  if (!fs::is_regular_file(name, ignored)) throw InputError(name, "exists and is no file; another name would be right");
  if (!force) throw InputError(name, "exists already; another name, or --force, would be right");
}

AtomicFile::AtomicFile(const std::string& name, bool force) : name_(name), guard_(name + ".partial") {
  refuse_existing(name, force);
  file_ = std::make_unique<OutputFile>(name + ".partial", traces::open_locked(name + ".partial"));
}

AtomicFile::~AtomicFile() {
  if (!file_) return;
  std::error_code ignored;
  fs::remove(file_->name(), ignored);
}

void AtomicFile::close() {
  file_->flush();
  std::error_code error;
  fs::rename(file_->name(), name_, error);  // while it is locked
  if (error) throw FileError(name_, "cannot write: " + error.message());
  const std::unique_ptr<OutputFile> file = std::move(file_);
  file->close();
}

void write_file(const std::string& name, std::string_view text) {
  OutputFile file(name);
  file.write(text);
  file.close();
}

void refuse_irregular(const std::string& name) {
  std::error_code ignored;
  switch (fs::status(name, ignored).type()) {
    case fs::file_type::directory:
      throw InputError(name, "is a folder; a file would be right");
    case fs::file_type::fifo:
      throw InputError(name, "is a pipe; a regular file would be right");
    case fs::file_type::character:
    case fs::file_type::block:
      throw InputError(name, "is a device; a regular file would be right");
    case fs::file_type::socket:
      throw InputError(name, "is a socket; a regular file would be right");
    default:  // what is not there, or cannot be reached, is reported by who opens it
      return;
  }
}

FileError file_error_of(const fs::filesystem_error& error) {
  return {error.path1().string(), error.code().message() + "; a file or folder that can be used would be right"};
}

std::string read_file(const std::string& name) {
  refuse_irregular(name);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"), std::fclose);
  if (!file) throw FileError(name, std::string("cannot read: ") + std::strerror(errno));
  std::string bytes;
  char buffer[1 << 16];
  while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, file.get())) bytes.append(buffer, got);
  if (std::ferror(file.get())) throw FileError(name, std::string("cannot read: ") + std::strerror(errno));
  return bytes;
}

}  // namespace artu::sim
