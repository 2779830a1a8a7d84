// The folder of a run, as `artu explain` and `artu report` read it back.
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "fuzz/harness.h"
#include "sim/explain/explain.h"
#include "sim/explain/stored_run.h"
#include "sim/html/page.h"
#include "sim/html/report_data.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artu;
  static fuzz::Sandbox sandbox;
  const std::string folder = sandbox.write_folder("run", std::string(reinterpret_cast<const char*>(data), size));
  fuzz::read_or_refuse([&] {
    const sim::StoredRun run = sim::read_run(folder);
    try {
      const sim::Explanation explanation = sim::explain(run.totals, run.unit);
      fuzz::require(!sim::format_explanation(explanation).empty(), "an explanation");
    } catch (const std::logic_error&) {  // the command says of which file: a counter is missing
    }
  });
  fuzz::read_or_refuse([&] {
    std::vector<std::string> notes;
    const auto page = sim::report_data({folder}, 1 << 20, notes);
    const std::string html = sim::html_page(sim::report_title(page), page);
    fuzz::require(html.find("</html>") != std::string::npos, "a page that ends");
  });
  return 0;
}
