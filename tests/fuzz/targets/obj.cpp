// Wavefront OBJ, and after a line "%MTL" the material library scene.mtl.
#include <string>

#include "fuzz/harness.h"
#include "fuzz/scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static artu::fuzz::Sandbox sandbox;
  static const bool furnished = (sandbox.furnish(), true);
  (void)furnished;
  const std::string text(reinterpret_cast<const char*>(data), size), mark = "\n%MTL\n";
  const std::size_t split = text.find(mark);
  sandbox.write("scene.mtl", split == std::string::npos ? "" : text.substr(split + mark.size()));
  artu::fuzz::import_scene(sandbox.write("scene.obj", text.substr(0, split)));
  return 0;
}
