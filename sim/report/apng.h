// A moving picture: an animated PNG, which browsers and most viewers play, and others show the first frame of.
//
// The format is that of the PNG specification, third edition (W3C, 2025), section 11.3.6 (acTL, fcTL, fdAT); every
// frame is a whole one, and the animation repeats for ever.
#pragma once

#include <cstdint>
#include <string>

#include "sim/report/file.h"

namespace artu::sim {

class AnimatedPng {
 public:
  /// `frames` pictures of one size will be added, shown at `fps` a second.
  AnimatedPng(const std::string& file, std::uint32_t frames, double fps);
  /// The bytes of a picture's PNG file.
  void add(const std::string& png);
  void close();  // after the last frame

 private:
  void chunk(const char* type, const std::string& data);
  void begin_frame(const std::string& header);

  OutputFile out_;
  std::uint32_t frames_, added_ = 0;
  std::uint32_t sequence_ = 0;  // of fcTL and fdAT chunks
  std::uint16_t delay_;         // of a frame, in milliseconds
};

/// CRC-32 of a PNG chunk's type and data.
std::uint32_t crc32_of(const std::string& bytes);

}  // namespace artu::sim
