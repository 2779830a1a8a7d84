// What all fuzz targets share: a folder in memory, and what a reader may say of bad bytes.
//
// A target is a LLVMFuzzerTestOneInput.  With libFuzzer (preset `fuzz`) it is a fuzzer; without, replay.cpp runs it
// over the files of its corpus, which is how ctest keeps what a fuzzer has found found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace artu::fuzz {

/// A folder of this process alone, in memory where the system has such a place; gone at exit.
class Sandbox {
 public:
  Sandbox();
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::uint8_t* bytes, std::size_t size) const;
  std::string write(const std::string& name, const std::string& bytes) const;
  /// One text of several files, "%FILE name" before each: the folder `name` then holds these, and no others.
  std::string write_folder(const std::string& name, const std::string& text) const;
  /// Files that scenes of a corpus refer to: data.bin, texture.png, model.gltf, model.obj, model.mtl.
  void furnish() const;

 private:
  std::string path_;
};

/// An InputError with a text is what bad bytes are answered with; whatever else is thrown ends the program.
void read_or_refuse(const std::function<void()>& read);

/// Ends the program, which is a finding, unless `holds`.
void require(bool holds, const char* what);

}  // namespace artu::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
