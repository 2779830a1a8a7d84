#include "sim/report/digest.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>

#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {

namespace {

class Sha256 {
 public:
  Sha256() { check(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1); }
  void add(const void* bytes, std::size_t count) { check(EVP_DigestUpdate(context_.get(), bytes, count) == 1); }
  std::string text() {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned length = 0;
    check(EVP_DigestFinal_ex(context_.get(), digest, &length) == 1);
    std::string text;
    for (unsigned i = 0; i < length; ++i) text += fmt::format("{:02x}", digest[i]);
    return text;
  }

 private:
  static void check(bool fine) {
    if (!fine) throw std::runtime_error("SHA-256 failed");
  }
  const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_{EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

}  // namespace

std::string sha256_of_file(const std::string& file) {
  refuse_irregular(file);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"), std::fclose);
  if (!in) throw FileError(file, std::string("cannot read: ") + std::strerror(errno));
  Sha256 sum;
  char buffer[1 << 16];
  while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, in.get())) sum.add(buffer, got);
  if (std::ferror(in.get())) throw FileError(file, std::string("cannot read: ") + std::strerror(errno));
  return sum.text();
}

std::string sha256_of_files(const std::string& file, const std::set<std::string>& others) {
  namespace fs = std::filesystem;
  const std::string own = sha256_of_file(file);  // first: it says so if the file is gone
  const fs::path itself = fs::canonical(file);
  std::map<std::string, std::string> names;
  for (const std::string& other : others) {
    if (other != itself) names[fs::path(other).lexically_relative(itself.parent_path()).string()] = other;
  }
  if (names.empty()) return own;
  std::string list = fmt::format("{}  {}\n", own, itself.filename().string());
  for (const auto& [name, path] : names) list += fmt::format("{}  {}\n", sha256_of_file(path), name);
  return sha256_of(list);
}

std::string sha256_of(std::string_view text) {
  Sha256 sum;
  sum.add(text.data(), text.size());
  return sum.text();
}

}  // namespace artu::sim
