// The frame trace: file format, reader and writer.
//
// A file is a sequence of zstd frames, each of one FlatBuffer (frame.fbs, verified before use): a
// header, materials and textures, static geometry in parts, then one chunk a frame.  Frames can be
// written and read one at a time; `zstd -t` checks a file, and the format is described in docs/traces.md.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "traces/frame.h"

namespace artu::traces {

/// Writes FILE.partial and renames it at close(): no half-written trace under the final name.
class Writer {
 public:
  /// Writes the scene; `scene.frame_count` frames must follow.  Throws InputError (cannot write, invalid).
  Writer(const std::string& path, const Scene& scene);
  ~Writer();  // without close(): removes the partial file
  void add(const Frame& frame);
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads a trace from an untrusted file.  Every error is an InputError that names the file and the chunk.
class Reader {
 public:
  explicit Reader(const std::string& path);
  ~Reader();
  const Scene& scene() const;
  /// Frame number `position` (0 ... frame_count - 1 in file order), in any order.
  Frame frame(std::uint32_t position) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Whether the file starts as a trace does (to tell it from a scene file).
bool is_trace(const std::string& path);

}  // namespace artu::traces
