// Traces.  Mutations happen inside the compressed chunks, or the checksums would refuse nearly all of them.
#include <zstd.h>

#include <algorithm>
#include <vector>

#include "fuzz/harness.h"
#include "traces/trace.h"

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t largest_chunk = 1 << 20;

Bytes expanded(const std::uint8_t* data, std::size_t size) {
  const auto length = ZSTD_getFrameContentSize(data, size);
  if (length == ZSTD_CONTENTSIZE_ERROR || length == ZSTD_CONTENTSIZE_UNKNOWN || length > largest_chunk) return {};
  Bytes bytes(length);
  if (ZSTD_isError(ZSTD_decompress(bytes.data(), bytes.size(), data, size))) return {};
  return bytes;
}

Bytes compressed(const Bytes& content) {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  Bytes bytes(ZSTD_compressBound(content.size()));
  bytes.resize(ZSTD_compress2(context, bytes.data(), bytes.size(), content.data(), content.size()));
  ZSTD_freeCCtx(context);
  return bytes;
}

/// The chunks as they are in the file; what is not one is the last.
std::vector<Bytes> frames_of(const std::uint8_t* data, std::size_t size) {
  std::vector<Bytes> frames;
  while (size > 0) {
    std::size_t length = ZSTD_findFrameCompressedSize(data, size);
    if (ZSTD_isError(length)) length = size;
    frames.emplace_back(data, data + length);
    data += length;
    size -= length;
  }
  return frames;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most)
    __attribute__((weak));  // not there in a replay

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
  std::vector<Bytes> frames = frames_of(data, size);
  if (frames.empty() || seed % 16 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::size_t at = seed / 16 % frames.size();
  if (seed / 4096 % 16 == 0) {  // chunks in another order, twice or missing
    const std::size_t other = seed / 65536 % frames.size();
    switch (seed / 16777216 % 3) {
      case 0:
        std::swap(frames[at], frames[other]);
        break;
      case 1:
        frames.insert(frames.begin() + static_cast<std::ptrdiff_t>(at), Bytes(frames[other]));
        break;
      default:
        frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(at));
    }
  } else {
    Bytes content = expanded(frames[at].data(), frames[at].size());
    const std::size_t length = content.size();
    content.resize(length + 4096);
    content.resize(LLVMFuzzerMutate(content.data(), length, content.size()));
    frames[at] = compressed(content);
  }
  std::size_t total = 0;
  for (const Bytes& frame : frames) total += frame.size();
  if (total > most) return LLVMFuzzerMutate(data, size, most);
  for (const Bytes& frame : frames) data = std::copy(frame.begin(), frame.end(), data);
  return total;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artu;
  static fuzz::Sandbox sandbox;
  const std::string path = sandbox.write("scene.artu", data, size);
  traces::is_trace(path);
  fuzz::read_or_refuse([&] {
    const traces::Reader reader(path);
    const std::uint32_t frames = std::min(reader.scene().frame_count, 4u);
    for (std::uint32_t frame = 0; frame < frames; ++frame) reader.frame(frame);
  });
  return 0;
}
