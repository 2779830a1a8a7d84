// A picture of 8-bit sRGB codes, and its PNG file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace artu::sim {

struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // row 0 first, 3 bytes a pixel
};

/// The bytes of a PNG file; throws InputError where the picture is too large for one, with the name of the file it is
/// for.
std::string encode_png(const std::string& file, const Image& image);

/// Both throw InputError with the file's name.  Alpha is dropped on reading.
void write_png(const std::string& file, const Image& image);
Image read_png(const std::string& file);

}  // namespace artu::sim
