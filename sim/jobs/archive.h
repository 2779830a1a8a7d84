// Values as bytes and back, from one process of the program to a copy of it: nothing for a file.
//
// A type of its own that is not trivially copyable has `template <class A> void transfer(A&, Type&)`, which hands
// its fields to pass_all; writing and reading then cannot disagree.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace artu::sim {

class ByteWriter {
 public:
  void bytes(void* from, std::size_t count) { bytes_.append(static_cast<const char*>(from), count); }
  void size(std::uint64_t& count) { bytes(&count, sizeof count); }
  std::string take() { return std::move(bytes_); }
  static constexpr bool reads = false;

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(bytes) {}
  void bytes(void* to, std::size_t count) {
    need(count);
    if (count != 0) std::memcpy(to, bytes_.data() + at_, count);
    at_ += count;
  }
  /// Of elements that take a byte or more.
  void size(std::uint64_t& count) {
    bytes(&count, sizeof count);
    need(count);
  }
  bool at_end() const { return at_ == bytes_.size(); }
  static constexpr bool reads = true;

 private:
  void need(std::uint64_t count) const {
    if (count > bytes_.size() - at_) throw std::logic_error("a result of another process ends too early");
  }
  const std::string& bytes_;
  std::size_t at_ = 0;
};

template <class A, class T>
void pass(A& archive, T& value);

template <class A, class T>
void transfer(A& archive, std::vector<T>& values) {
  std::uint64_t count = values.size();
  archive.size(count);
  values.resize(count);
  if constexpr (std::is_trivially_copyable_v<T>) {
    archive.bytes(values.data(), count * sizeof(T));
  } else {
    for (T& value : values) pass(archive, value);
  }
}

template <class A>
void transfer(A& archive, std::string& text) {
  std::uint64_t count = text.size();
  archive.size(count);
  text.resize(count);
  archive.bytes(text.data(), count);
}

template <class A, class T>
void transfer(A& archive, std::optional<T>& value) {
  bool there = value.has_value();
  pass(archive, there);
  if (!there) {
    value.reset();
    return;
  }
  if (!value) value.emplace();
  pass(archive, *value);
}

template <class A, class First, class Second>
void transfer(A& archive, std::pair<First, Second>& pair) {
  pass(archive, pair.first);
  pass(archive, pair.second);
}

template <class A, class Key, class T>
void transfer(A& archive, std::map<Key, T>& values) {
  std::vector<std::pair<Key, T>> pairs(values.begin(), values.end());
  std::uint64_t count = pairs.size();
  archive.size(count);
  pairs.resize(count);
  for (auto& pair : pairs) pass(archive, pair);
  if constexpr (A::reads) values = std::map<Key, T>(pairs.begin(), pairs.end());
}

template <class A, class T>
void pass(A& archive, T& value) {
  if constexpr (std::is_trivially_copyable_v<T>) {
    archive.bytes(&value, sizeof value);
  } else {
    transfer(archive, value);
  }
}

/// The fields of a type, in one order for both ways.
template <class A, class... T>
void pass_all(A& archive, T&... values) {
  (pass(archive, values), ...);
}

template <class T>
std::string to_bytes(T value) {
  ByteWriter writer;
  pass(writer, value);
  return writer.take();
}

template <class T>
T from_bytes(const std::string& bytes) {
  ByteReader reader(bytes);
  T value;
  pass(reader, value);
  if (!reader.at_end()) throw std::logic_error("a result of another process is too long");
  return value;
}

}  // namespace artu::sim
