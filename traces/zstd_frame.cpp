#include "traces/zstd_frame.h"

#include <zstd.h>

#include <algorithm>
#include <new>
#include <vector>

#include "traces/error.h"
#include "traces/limits.h"

namespace artu::traces {
namespace {

// Part of the format's promise of equal bytes for equal input.
constexpr int compression_level = 3;

constexpr std::size_t buffer_size = 1 << 17;

struct FreeContext {
  void operator()(ZSTD_CCtx* c) const { ZSTD_freeCCtx(c); }
  void operator()(ZSTD_DCtx* c) const { ZSTD_freeDCtx(c); }
};

template <typename Context>
std::unique_ptr<Context, FreeContext> owned(Context* context) {
  if (!context) throw std::bad_alloc();
  return std::unique_ptr<Context, FreeContext>(context);
}

std::size_t checked(std::size_t result, const std::string& where, const char* doing) {
  if (ZSTD_isError(result)) throw InputError(where, std::string(doing) + ": " + ZSTD_getErrorName(result));
  return result;
}

}  // namespace

void Bytes::resize(std::size_t size) {
  void* grown = std::realloc(data_.get(), std::max<std::size_t>(size, 1));
  if (!grown) throw std::bad_alloc();
  static_cast<void>(data_.release());
  data_.reset(static_cast<std::uint8_t*>(grown));
  size_ = size;
}

Bytes decompress(const InputFile& file, const ZstdFrame& frame, const std::string& where) {
  constexpr const char* damaged = "damaged (zstd)";
  const auto context = owned(ZSTD_createDCtx());
  checked(ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, max_window_log), where, damaged);

  const auto content_size = static_cast<std::size_t>(frame.content_size);
  std::vector<char> buffer(std::min<std::uint64_t>(frame.size, buffer_size));
  Bytes bytes;
  bytes.resize(std::min(content_size, 8 * buffer_size));
  ZSTD_inBuffer in{buffer.data(), 0, 0};
  std::uint64_t read = 0;
  std::size_t produced = 0;
  for (bool more = true; more;) {
    if (in.pos == in.size && read < frame.size) {
      const auto want = static_cast<std::size_t>(std::min<std::uint64_t>(buffer.size(), frame.size - read));
      in.size = file.read(frame.offset + read, buffer.data(), want);
      if (in.size != want) throw InputError(where, "the file became shorter while it was read");
      in.pos = 0;
      read += want;
    }
    if (produced == bytes.size() && produced < content_size) bytes.resize(std::min(content_size, 2 * produced));
    ZSTD_outBuffer out{bytes.data(), bytes.size(), produced};
    const std::size_t consumed = in.pos;
    const bool at_end = checked(ZSTD_decompressStream(context.get(), &out, &in), where, damaged) == 0;
    more = !at_end && (in.pos > consumed || out.pos > produced);
    produced = out.pos;
    if (at_end && in.pos == in.size && read == frame.size && produced == content_size) return bytes;
  }
  throw InputError(where, "damaged (zstd): the content does not have the declared size");
}

void compress(OutputFile& file, const std::uint8_t* data, std::size_t size, const std::string& where) {
  constexpr const char* doing = "cannot compress (zstd)";
  const auto context = owned(ZSTD_createCCtx());
  checked(ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, compression_level), where, doing);
  checked(ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1), where, doing);
  checked(ZSTD_CCtx_setPledgedSrcSize(context.get(), size), where, doing);

  std::vector<char> buffer(buffer_size);
  ZSTD_inBuffer in{data, size, 0};
  for (std::size_t left = 1; left != 0;) {
    ZSTD_outBuffer out{buffer.data(), buffer.size(), 0};
    left = checked(ZSTD_compressStream2(context.get(), &out, &in, ZSTD_e_end), where, doing);
    file.write(buffer.data(), out.pos);
  }
}

}  // namespace artu::traces
