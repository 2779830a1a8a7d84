#include <cstring>
#include <utility>

#include "traces/error.h"
#include "traces/file.h"
#include "traces/pack.h"
#include "traces/trace.h"
#include "traces/validate.h"
#include "traces/zstd_frame.h"

namespace artu::traces {
namespace {

// By bytes and not by value, as the file's checksums compare them: -0 is not 0.
template <typename T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same(const Mesh& a, const Mesh& b) {
  return same(a.positions, b.positions) && same(a.normals, b.normals) && same(a.uvs, b.uvs) &&
         same(a.colors, b.colors) && same(a.indices, b.indices) && same(a.materials, b.materials);
}

/// Validates before the file is created.
const Scene& validated(const Scene& scene, const std::string& where) {
  validate(scene, where);
  if (scene.frame_count == 0) throw InputError(where, "frame_count is 0; a trace has at least one frame");
  return scene;
}

}  // namespace

struct Writer::Impl {
  Impl(const std::string& to, const Scene& scene) : path(to), frame_count(validated(scene, to).frame_count), file(to) {
    outline.materials.resize(scene.materials.size());
    pack(scene, sink());
  }

  ChunkSink sink() {
    return [this](const std::uint8_t* data, std::size_t size) { compress(file, data, size, path); };
  }

  void add(const Frame& frame) {
    const std::string where = path + ": frame " + std::to_string(added);
    if (broken || closed) throw InputError(where, "cannot be added: the trace is closed or an earlier write failed");
    if (added == frame_count) {
      throw InputError(where, "is one too many: the scene's frame_count is " + std::to_string(frame_count));
    }
    validate(outline, frame, where);
    if (!frame.dynamic_moved && added > 0 && !same(frame.dynamic, previous)) {
      throw InputError(where, "dynamic_moved is false, but the dynamic geometry differs from the preceding frame's");
    }
    broken = true;  // unless all of the frame is written
    pack(frame, sink());
    previous = frame.dynamic;
    ++added;
    broken = false;
  }

  void close() {
    if (closed) return;
    if (broken) throw InputError(path, "cannot be closed: an earlier write failed");
    if (added != frame_count) {
      throw InputError(
          path, "has " + std::to_string(added) + " frames; its scene's frame_count is " + std::to_string(frame_count));
    }
    file.commit();
    closed = true;
  }

  std::string path;
  std::uint32_t frame_count, added = 0;
  OutputFile file;
  Scene outline;  // what validate() needs of the scene to check a frame
  Mesh previous;  // the last frame's dynamic geometry
  bool broken = false, closed = false;
};

Writer::Writer(const std::string& path, const Scene& scene) : impl_(std::make_unique<Impl>(path, scene)) {}
Writer::~Writer() = default;
void Writer::add(const Frame& frame) { impl_->add(frame); }
void Writer::close() { impl_->close(); }

}  // namespace artu::traces
