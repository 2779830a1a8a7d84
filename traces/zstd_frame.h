// One zstd frame of a trace: finding where it ends, compressing, and decompressing without trust.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "traces/file.h"

namespace artu::traces {

/// A zstd frame in a file, by its own headers.
struct ZstdFrame {
  std::uint64_t offset = 0;
  std::uint64_t size = 0;          // compressed, with headers and checksum
  std::uint64_t content_size = 0;  // decompressed, as declared; not more than its blocks can hold
  std::uint32_t checksum = 0;      // of the content: the low half of its XXH64
};

/// Bytes with the alignment that a FlatBuffer needs, grown as they arrive.
class Bytes {
 public:
  const std::uint8_t* data() const { return data_.get(); }
  std::uint8_t* data() { return data_.get(); }
  std::size_t size() const { return size_; }
  void resize(std::size_t size);  // new bytes are not initialised

 private:
  struct Free {
    void operator()(std::uint8_t* p) const { std::free(p); }
  };
  std::unique_ptr<std::uint8_t, Free> data_;
  std::size_t size_ = 0;
};

/// Reads the headers of the frame at `offset` and of its blocks.  `where` goes into the InputErrors.
ZstdFrame scan_frame(const InputFile& file, std::uint64_t offset, const std::string& where);

/// The content of a scanned frame.  Memory grows with what the data really gives, not with what it declares.
Bytes decompress(const InputFile& file, const ZstdFrame& frame, const std::string& where);

/// Appends one frame with content size and checksum.
void compress(OutputFile& file, const std::uint8_t* data, std::size_t size, const std::string& where);

}  // namespace artu::traces
