#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

struct Pictures {
  std::string a, b;
};

int run(const Pictures& pictures) { return diff_command(pictures.a, pictures.b); }

}  // namespace

void add_diff(CommandLine& line) {
  const auto pictures = std::make_shared<Pictures>();
  CLI::App& command =
      add_command(line, "diff", "How far two PNG pictures are apart: PSNR, SSIM, FLIP, share of pixels", pictures, run);
  command.add_option("A.png", pictures->a, "A picture")->option_text(" ")->required();
  command.add_option("B.png", pictures->b, "Another, of the same size")->option_text(" ")->required();
  add_examples(command, {{"artu diff a.png b.png", "exit code 0 whenever they could be compared"}});
}

}  // namespace artu::sim
