// Configurations: TOML files, and `--set` of each line after "%SET".  What is accepted, `--dump-config` prints so
// that it is the same configuration again.
#include <sstream>
#include <string>

#include "fuzz/harness.h"
#include "sim/config/configuration.h"
#include "sim/config/dump.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artu;
  static fuzz::Sandbox sandbox;
  const std::string text(reinterpret_cast<const char*>(data), size), mark = "\n%SET\n";
  const std::size_t split = text.find(mark);
  const std::string file = sandbox.write("unit.toml", text.substr(0, split));
  fuzz::read_or_refuse([&] {
    sim::Configuration configuration;
    configuration.load(file);
    if (split != std::string::npos) {
      std::istringstream lines(text.substr(split + mark.size()));
      for (std::string line; std::getline(lines, line);) configuration.set(line);
    }
    configuration.check();
    const std::string dump = sim::dump_config(configuration.unit());
    sim::Configuration again;
    again.load(sandbox.write("dump.toml", dump));
    again.check();
    fuzz::require(sim::dump_config(again.unit()) == dump, "what is dumped loads to the same");
  });
  return 0;
}
