// glTF: text, or binary where the bytes begin as such a file does.
#include <cstring>

#include "fuzz/harness.h"
#include "fuzz/scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static artu::fuzz::Sandbox sandbox;
  static const bool furnished = (sandbox.furnish(), true);
  (void)furnished;
  const bool binary = size >= 4 && std::memcmp(data, "glTF", 4) == 0;
  artu::fuzz::import_scene(sandbox.write(binary ? "scene.glb" : "scene.gltf", data, size));
  return 0;
}
