// The metrics of `artu diff` against other programs for the same.
#include <cmath>
#include <sstream>

#include "end_to_end/program.h"
#include "sim/report/image.h"

namespace artu::test {
namespace {

class MetricsTest : public ProgramTest {
 protected:
  MetricsTest() {
    // Something with flat parts, edges, thin lines and colours; then the same blurred, shifted and darkened in parts.
    sim::Image a{97, 61, {}};
    for (std::uint32_t y = 0; y < a.height; ++y) {
      for (std::uint32_t x = 0; x < a.width; ++x) {
        const bool line = x % 13 == 5 || (x + y) % 17 == 3, disc = std::hypot(x - 60.0, y - 30.0) < 17;
        a.rgb.push_back(static_cast<std::uint8_t>(line ? 250 : disc ? 200 - 3 * y : 2 * x + 10));
        a.rgb.push_back(static_cast<std::uint8_t>(line ? 240 : disc ? 40 : 90 + y));
        a.rgb.push_back(static_cast<std::uint8_t>(line ? 230 : disc ? 4 * y : 160 - x));
      }
    }
    sim::Image b = a;
    for (std::size_t i = 3; i < b.rgb.size(); ++i) {
      if (i / 3 % 97 > 30 && i % 2 == 0) b.rgb[i] = static_cast<std::uint8_t>((a.rgb[i] + a.rgb[i - 3]) / 2);
      if (i > b.rgb.size() / 2 && i % 5 != 0) b.rgb[i] = static_cast<std::uint8_t>(b.rgb[i] * 7 / 8);
    }
    sim::write_png(path("a.png"), a);
    sim::write_png(path("b.png"), b);
  }

  /// The first Python that has the module; "" without one.
  std::string python_with(const std::string& module) {
    for (const char* python : {"/usr/bin/python3", "/usr/local/bin/python3"}) {
      if (program(python, {"-c", "import " + module}).code == 0) return python;
    }
    return "";
  }

  /// The number that a script of tests/end_to_end prints for the two pictures.
  double by_script(const std::string& python, const std::string& script) {
    const Finished run = program(
        python, {"-B", std::string(ARTU_SOURCE_DIR) + "/tests/end_to_end/" + script, path("a.png"), path("b.png")});
    EXPECT_EQ(run.code, 0) << run.err;
    return std::stod(run.out);
  }

  double by_artu(const std::string& metric) {
    std::istringstream lines(fine({"diff", "a.png", "b.png"}).out);
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind(metric, 0) == 0) return std::stod(line.substr(metric.size()));
    }
    return std::nan("");
  }
};

TEST_F(MetricsTest, FlipIsThatOfAnotherProgramFromThePaper) {
  EXPECT_NEAR(by_artu("FLIP"), 0.259196, 1e-5);  // flip.py
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << "skipped: no python3-numpy";
  EXPECT_NEAR(by_artu("FLIP"), by_script(python, "flip.py"), 2e-6);
}

TEST_F(MetricsTest, SsimIsThatOfScikitImage) {
  EXPECT_NEAR(by_artu("SSIM"), 0.853969, 1e-5);  // ssim.py
  const std::string python = python_with("skimage");
  if (python.empty()) GTEST_SKIP() << "skipped: no python3-skimage";
  EXPECT_NEAR(by_artu("SSIM"), by_script(python, "ssim.py"), 2e-6);
}

}  // namespace
}  // namespace artu::test
