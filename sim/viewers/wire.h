// The wire format of protocol buffers, as much of it as a trace needs.
// Source: protobuf.dev/programming-guides/encoding.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace artu::sim {

/// One message; its fields in the order of the calls.
class WireMessage {
 public:
  void clear() { bytes_.clear(); }
  const std::string& bytes() const { return bytes_; }

  void varint(std::uint32_t field, std::uint64_t value) {
    key(field, 0);
    number(value);
  }
  void fixed64(std::uint32_t field, std::uint64_t value) {
    key(field, 1);
    for (int i = 0; i < 8; ++i) bytes_ += static_cast<char>(value >> (8 * i));
  }
  void text(std::uint32_t field, std::string_view value) {
    key(field, 2);
    number(value.size());
    bytes_ += value;
  }
  void message(std::uint32_t field, const WireMessage& value) { text(field, value.bytes_); }

 private:
  void key(std::uint32_t field, std::uint32_t type) { number(field << 3 | type); }
  void number(std::uint64_t value) {
    for (; value >= 128; value >>= 7) bytes_ += static_cast<char>(value | 128);
    bytes_ += static_cast<char>(value);
  }

  std::string bytes_;
};

}  // namespace artu::sim
