#include "sim/import/image.h"

#include <cmath>
#include <limits>
#include <memory>

#include "traces/error.h"

// Static, since other libraries in the same program bring an stb of their own.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace artu::sim {
namespace {

constexpr int max_side = 16384;

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

template <typename Decode>
std::array<double, 4> mean_of(const DecodedImage& image, Decode decode) {
  std::array<std::array<std::uint64_t, 256>, 4> histogram{};
  for (std::size_t i = 0; i < image.rgba.size(); ++i) ++histogram[i % 4][image.rgba[i]];
  std::array<double, 4> mean{};
  const std::size_t pixels = image.rgba.size() / 4;
  const double count = static_cast<double>(pixels);
  for (int c = 0; c < 4; ++c) {
    double sum = 0;
    for (int code = 0; code < 256; ++code)
      sum += static_cast<double>(histogram[c][code]) * (c < 3 ? decode(code / 255.0) : code / 255.0);
    mean[c] = count > 0 ? sum / count : 1;
  }
  return mean;
}

}  // namespace

std::array<double, 4> DecodedImage::mean() const {
  return mean_of(*this, [](double c) { return c; });
}

std::array<double, 4> DecodedImage::mean_linear() const { return mean_of(*this, linear); }

DecodedImage decode_image(const std::uint8_t* bytes, std::size_t size, const std::string& where) {
  if (size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError(where, "image file is over 2 GiB");
  const int length = static_cast<int>(size);
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(bytes, length, &width, &height, &channels))
    throw InputError(where, "is neither a PNG nor a JPEG image that can be read");
  // Checked before anything is allocated: the header alone decides how much memory decoding takes.
  if (width < 1 || height < 1 || width > max_side || height > max_side)
    throw InputError(where, "image is " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels; 1 ... 16384 each way is allowed");
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes, length, &width, &height, &channels, 4), stbi_image_free);
  if (!pixels)
    throw InputError(where, std::string("broken image: ") + (stbi_failure_reason() ? stbi_failure_reason() : ""));
  DecodedImage image;
  image.width = static_cast<std::uint32_t>(width);
  image.height = static_cast<std::uint32_t>(height);
  image.rgba.assign(pixels.get(), pixels.get() + static_cast<std::size_t>(width) * height * 4);
  return image;
}

}  // namespace artu::sim
