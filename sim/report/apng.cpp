#include "sim/report/apng.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace artu::sim {
namespace {

constexpr std::size_t signature = 8;

std::string big_endian(std::uint32_t value, int bytes = 4) {
  std::string out;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 255);
  return out;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

/// The data of all chunks of a type, one after the other.
std::string data_of(const std::string& png, std::string_view type) {
  std::string data;
  for (std::size_t at = signature; at < png.size();) {
    const std::size_t length = number_at(png, at);
    if (png.compare(at + 4, 4, type) == 0) data += png.substr(at + 8, length);
    at += length + 12;
  }
  return data;
}

}  // namespace

std::uint32_t crc32_of(const std::string& bytes) {
  std::uint32_t crc = ~std::uint32_t{0};
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

AnimatedPng::AnimatedPng(const std::string& file, std::uint32_t frames, double fps)
    : out_(file),
      frames_(frames),
      delay_(static_cast<std::uint16_t>(std::clamp(std::lround(1000 / fps), 1l, 65535l))) {}

void AnimatedPng::chunk(const char* type, const std::string& data) {
  const std::string body = type + data;
  out_.write(big_endian(static_cast<std::uint32_t>(data.size())));
  out_.write(body);
  out_.write(big_endian(crc32_of(body)));
}

void AnimatedPng::begin_frame(const std::string& header) {
  const std::string at_origin(8, '\0'), replace_all(2, '\0');
  chunk("fcTL", big_endian(sequence_++) + header.substr(0, 8) + at_origin + big_endian(delay_, 2) +
                    big_endian(1000, 2) + replace_all);
}

void AnimatedPng::add(const std::string& png) {
  if (added_ == frames_) throw std::logic_error(out_.name() + ": more frames than were announced");
  const std::string header = data_of(png, "IHDR"), pixels = data_of(png, "IDAT");
  if (added_++ == 0) {
    out_.write(png.substr(0, signature));
    chunk("IHDR", header);
    chunk("acTL", big_endian(frames_) + big_endian(0));  // 0: for ever
    begin_frame(header);
    chunk("IDAT", pixels);
  } else {
    begin_frame(header);
    chunk("fdAT", big_endian(sequence_++) + pixels);
  }
}

void AnimatedPng::close() {
  if (added_ != frames_) throw std::logic_error(out_.name() + ": fewer frames than were announced");
  chunk("IEND", "");
  out_.close();
}

}  // namespace artu::sim
