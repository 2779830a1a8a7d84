#include "sim/report/image.h"

#include <limits>
#include <memory>

#include "sim/report/file.h"
#include "traces/error.h"

// Static: tinygltf's library may bring a copy of stb of its own.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace artu::sim {

std::string encode_png(const std::string& file, const Image& image) {
  std::string bytes;
  const auto write = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  const int ok = stbi_write_png_to_func(write, &bytes, static_cast<int>(image.width), static_cast<int>(image.height), 3,
                                        image.rgb.data(), static_cast<int>(image.width * 3));
  if (!ok) throw InputError(file, "cannot encode the picture; a smaller --size would be right");
  return bytes;
}

void write_png(const std::string& file, const Image& image) { write_file(file, encode_png(file, image)); }

Image read_png(const std::string& file) {
  const std::string bytes = read_file(file);
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw InputError(file, "larger than 2 GiB; a PNG picture would be right");
  }
  int width = 0, height = 0, channels = 0;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(data, static_cast<int>(bytes.size()), &width, &height, &channels, 3), stbi_image_free);
  if (!pixels) throw InputError(file, "not a PNG that can be read; a PNG picture would be right");
  Image image;
  image.width = static_cast<std::uint32_t>(width);
  image.height = static_cast<std::uint32_t>(height);
  image.rgb.assign(pixels.get(), pixels.get() + std::size_t{image.width} * image.height * 3);
  return image;
}

}  // namespace artu::sim
