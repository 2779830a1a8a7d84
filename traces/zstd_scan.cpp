// The frame and block headers of RFC 8878, section 3.1.1.  zstd's library can find a frame's end only
// with the whole frame in memory; here a block costs three bytes of reading, and the blocks bound
// what the content size may be.
#include <algorithm>
#include <array>

#include "traces/error.h"
#include "traces/zstd_frame.h"

namespace artu::traces {
namespace {

constexpr std::uint64_t magic = 0xFD2FB528;
constexpr std::uint64_t largest_block = 128 * 1024;

class Cursor {
 public:
  Cursor(const InputFile& file, std::uint64_t at, const std::string& where) : file_(file), at_(at), where_(where) {}

  std::uint64_t number(std::size_t bytes) {  // little-endian
    std::array<std::uint8_t, 8> raw{};
    if (file_.read(at_, raw.data(), bytes) != bytes) truncated();
    at_ += bytes;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value |= std::uint64_t{raw[i]} << (8 * i);
    return value;
  }

  void skip(std::uint64_t bytes) {
    if (bytes > file_.size() - std::min(at_, file_.size())) truncated();
    at_ += bytes;
  }

  std::uint64_t at() const { return at_; }

 private:
  [[noreturn]] void truncated() const {
    throw InputError(where_,
                     "the file ends within this chunk, at byte " + std::to_string(file_.size()) + "; is it cut off?");
  }

  const InputFile& file_;
  std::uint64_t at_;
  const std::string& where_;
};

std::uint64_t window_size(std::uint64_t descriptor) {
  const std::uint64_t base = 1ull << (10 + (descriptor >> 3));
  return base + base / 8 * (descriptor & 7);
}

}  // namespace

ZstdFrame scan_frame(const InputFile& file, std::uint64_t offset, const std::string& where) {
  Cursor cursor(file, offset, where);
  if (cursor.number(4) != magic) throw InputError(where, "no zstd frame begins here (it must begin with 28 b5 2f fd)");

  const std::uint64_t descriptor = cursor.number(1);
  const bool single_segment = descriptor & 0x20;
  if (descriptor & 0x08) throw InputError(where, "damaged: a reserved bit of the zstd frame's header is set");
  if (descriptor & 0x03) throw InputError(where, "needs a zstd dictionary; a trace's chunks must not use one");
  if (!(descriptor & 0x04)) throw InputError(where, "has no checksum; a trace's chunks must be compressed with one");
  std::uint64_t window = single_segment ? 0 : window_size(cursor.number(1));

  constexpr std::array<std::size_t, 4> content_size_bytes{0, 2, 4, 8};
  std::size_t bytes = content_size_bytes[descriptor >> 6];
  if (bytes == 0 && single_segment) bytes = 1;
  if (bytes == 0) throw InputError(where, "does not declare its decompressed size; a trace's chunks must");
  ZstdFrame frame;
  frame.offset = offset;
  frame.content_size = cursor.number(bytes) + (bytes == 2 ? 256 : 0);
  if (single_segment) window = frame.content_size;

  const std::uint64_t block_limit = std::min(window, largest_block);
  std::uint64_t possible = 0;  // what the blocks can decompress to
  for (bool last = false; !last;) {
    const std::uint64_t header = cursor.number(3);
    last = header & 1;
    const std::uint64_t kind = header >> 1 & 3, size = header >> 3;
    if (kind == 3 || size > block_limit) throw InputError(where, "damaged: a zstd block has no valid header");
    possible += kind == 2 ? block_limit : size;
    cursor.skip(kind == 1 ? 1 : size);  // kind 1 is one byte, repeated
  }
  if (frame.content_size > possible) {
    throw InputError(where, "declares " + std::to_string(frame.content_size) +
                                " bytes of content, but its compressed data can give at most " +
                                std::to_string(possible));
  }
  frame.checksum = static_cast<std::uint32_t>(cursor.number(4));
  frame.size = cursor.at() - offset;
  return frame;
}

}  // namespace artu::traces
