// Stages; the models that they may name are in the folder.
#include "fuzz/harness.h"
#include "fuzz/scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static artu::fuzz::Sandbox sandbox;
  static const bool furnished = (sandbox.furnish(), true);
  (void)furnished;
  artu::fuzz::import_scene(sandbox.write("scene.stage.toml", data, size));
  return 0;
}
