#include "sim/import/resource_path.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "sim/import/files_read.h"
#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

bool has_scheme(const std::string& uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string::npos || colon == 0) return false;
  return std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon),
                     [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; });
}

}  // namespace

std::string percent_decode(const std::string& uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0) {
      out += static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2]));
      i += 2;
    } else {
      out += uri[i];
    }
  }
  return out;
}

std::string resource_path(const std::string& folder, const std::string& uri, const std::string& where) {
  const std::string named = "\"" + uri.substr(0, 200) + "\"";
  const std::string allowed = "; a scene may only use files in its own folder, named by a relative path";
  if (uri.empty()) throw InputError(where, "empty file name");
  if (uri.find('\0') != std::string::npos) throw InputError(where, named + " has a zero byte in it");
  if (has_scheme(uri)) throw InputError(where, named + " has a scheme or a drive" + allowed);
  if (uri[0] == '/' || uri[0] == '\\') throw InputError(where, named + " is an absolute path" + allowed);
  for (const fs::path& part : fs::path(uri)) {
    if (part == "..") throw InputError(where, named + " leaves the scene's folder by \"..\"" + allowed);
  }
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) throw InputError(where, "folder \"" + folder + "\" cannot be read: " + error.message());
  const fs::path real = fs::canonical(root / uri, error);
  if (error) throw InputError(where, "file " + named + " cannot be read: " + error.message());
  if (std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first != root.end())
    throw InputError(where, named + " is a link that leaves the scene's folder" + allowed);
  if (!fs::is_regular_file(real, error)) throw InputError(where, named + " is not a regular file");
  return real.string();
}

std::string folder_of(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

std::vector<std::uint8_t> read_file(const std::string& path, std::uint64_t limit) {
  refuse_irregular(path);
  std::error_code error;
  if (!fs::exists(path, error)) throw InputError(path, "no such file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path, "cannot be opened for reading");
  in.seekg(0, std::ios::end);
  const auto size = in.tellg();
  if (size < 0) throw InputError(path, "is not a regular file");
  if (static_cast<std::uint64_t>(size) > limit)
    throw InputError(path, "has " + std::to_string(size) + " bytes, the limit is " + std::to_string(limit));
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  in.seekg(0);
  if (!bytes.empty()) in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in) throw InputError(path, "cannot be read to its end");
  FilesRead::note(path);
  return bytes;
}

}  // namespace artu::sim
