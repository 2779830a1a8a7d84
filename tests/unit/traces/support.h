// What the tests of the trace share: sample content, files, and chunks put together by hand.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "traces/error.h"
#include "traces/frame.h"

namespace artu::traces::test {

/// A folder that vanishes with the test.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

/// No field has its default value.
Scene sample_scene(std::uint32_t frame_count = 2);
Frame sample_frame(std::uint32_t number);
/// `vertices` and `triangles` with valid content that differs from one to the next.
Mesh sample_mesh(std::size_t vertices, std::size_t triangles, std::uint32_t materials, float offset = 0);

void expect_same(const Scene& a, const Scene& b);
void expect_same(const Frame& a, const Frame& b);
void expect_same(const Mesh& a, const Mesh& b);

using Raw = std::vector<std::uint8_t>;
Raw read_file(const std::string& path);
void write_file(const std::string& path, const Raw& bytes);

/// The chunks of a trace, not compressed; nothing is validated.
std::vector<Raw> chunks_of(const Scene& scene, const std::vector<Frame>& frames);
struct Zstd {
  bool checksum = true, content_size = true;
  int window_log = 0;  // 0: zstd's choice
};
Raw compressed(const Raw& content, Zstd options = {});
Raw joined(const std::vector<Raw>& chunks);  // each compressed

void write_trace(const std::string& path, const Scene& scene, const std::vector<Frame>& frames);
/// Reads and validates all there is.
void read_all(const std::string& path);
/// What read_all() refuses the bytes with; "" if it does not.
std::string refusal(const Raw& file);
/// The InputError's text, "" if there is none; any other exception passes.
std::string message_of(const std::function<void()>& action);

}  // namespace artu::traces::test
