// PNG and JPEG, to 8-bit RGBA.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace artu::sim {

struct DecodedImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // row 0 first; sixteen-bit images are reduced to eight

  /// Mean of each channel, 0 ... 1, of the stored codes (for data such as roughness).
  std::array<double, 4> mean() const;
  /// Mean of R, G and B after decoding sRGB (for colours); A as stored.
  std::array<double, 4> mean_linear() const;
};

/// Throws InputError(where, ...): not a PNG or JPEG, broken, or over 16384 pixels wide or high.
DecodedImage decode_image(const std::uint8_t* bytes, std::size_t size, const std::string& where);

}  // namespace artu::sim
