// Numbers out of a glTF file's buffers; every range is checked before a byte is read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/import/gltf_file.h"

namespace artu::sim {

class GltfAccessors {
 public:
  explicit GltfAccessors(const GltfFile& file) : file_(file) {}

  std::size_t count(int accessor, const std::string& where) const;
  /// Components an element, e.g. 3 for VEC3.
  int components(int accessor, const std::string& where) const;

  /// All elements as numbers, normalised integers as such, sparse ones patched in.  Refused: another number of
  /// components than one of `allowed` (a character each: "34" is VEC3 or VEC4, "@" is MAT4), numbers that are not
  /// finite.
  std::vector<float> floats(int accessor, const char* allowed, const std::string& where);
  /// Unsigned integers: vertex indices, joints.
  std::vector<std::uint32_t> integers(int accessor, const char* allowed, const std::string& where);

  /// The bytes of a buffer view, range checked.
  struct Bytes {
    const unsigned char* data;
    std::uint64_t size;
  };
  Bytes view(int buffer_view, const std::string& where) const;

 private:
  const tinygltf::Accessor& get(int accessor, const std::string& where) const;
  template <typename T, typename Convert>
  std::vector<T> read(const tinygltf::Accessor& a, Convert convert, const std::string& where);

  const GltfFile& file_;
  std::uint64_t decoded_ = 0;  // numbers so far, against files that decode the same bytes over and over
};

}  // namespace artu::sim
