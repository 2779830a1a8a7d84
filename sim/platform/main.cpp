// An example of a virtual platform that holds the unit: a processor, a memory, and TLM-2.0 between them (docs/tlm.md).
//
//   artu_platform TRACE OUT.png    renders the first frame of a trace, and compares every pixel with the golden model
#include <fmt/format.h>

#include "hw/border/tlm_ray_tracing_unit.h"
#include "sim/command/commands.h"
#include "sim/compare/frame_compare.h"
#include "sim/compare/golden_settings.h"
#include "sim/driver/image_builder.h"
#include "sim/driver/simulator.h"
#include "sim/platform/processor.h"
#include "sim/platform/ram.h"
#include "sim/report/file.h"
#include "sim/report/pictures.h"
#include "traces/error.h"
#include "traces/trace.h"

namespace artu::sim {
namespace {

constexpr std::uint64_t ram_base = 0x80000000;
const sc_core::sc_time accept_time(1, sc_core::SC_NS), latency(60, sc_core::SC_NS);

/// Processor and unit are each wired to the memory, the processor to the unit: there is no bus.
struct VirtualPlatform {
  VirtualPlatform(const hw::UnitConfig& config, const hw::MemoryImage& image, hw::Address descriptor)
      : ram("ram", ram_base, image.size(), accept_time, latency),
        unit("unit", config, {}, hw::TlmWindow{ram_base, image.size()}),
        processor("processor", image, ram_base, descriptor),
        interrupt("interrupt") {
    processor.memory.bind(ram.processor_port);
    processor.unit.bind(unit.registers);
    unit.memory.bind(ram.unit_port);
    unit.interrupt.bind(interrupt);
    processor.interrupt.bind(interrupt);
  }
  Ram ram;
  hw::TlmRayTracingUnit unit;
  Processor processor;
  sc_core::sc_signal<bool> interrupt;
};

/// What the processor has read back takes the place of what the unit's observer saw.
void take_pixels(const Processor& processor, std::uint32_t pitch, FrameOutcome& outcome) {
  for (std::uint32_t y = 0; y < outcome.height; ++y) {
    for (std::uint32_t x = 0; x < outcome.width; ++x) {
      hw::PixelRecord& pixel = outcome.pixels[std::size_t{y} * outcome.width + x];
      const std::size_t index = std::size_t{y} * pitch + x;
      pixel.r = processor.frame_buffer[index * 4];
      pixel.g = processor.frame_buffer[index * 4 + 1];
      pixel.b = processor.frame_buffer[index * 4 + 2];
      pixel.hit_class = static_cast<hw::HitClass>(processor.classes[index]);
    }
  }
}

int run(int argc, char** argv) {
  if (argc != 3) throw InputError("command line", "TRACE and OUT.png would be right");
  refuse_existing(argv[2], false);
  const traces::Reader trace(argv[1]);
  if (trace.scene().frame_count == 0) throw InputError(argv[1], "holds no frame; a trace with frames would be right");
  const traces::Frame frame = trace.frame(0);
  const hw::UnitConfig config;

  hw::MemoryImage image;
  ImageBuilder builder(trace.scene(), config, {}, image);
  const hw::Address descriptor = builder.add(frame);
  if (builder.stack_needed() > config.core.stack_entries) {
    throw InputError(argv[1], "the tree needs a deeper stack than the unit has");
  }

  hw::PixelRecords pixels(std::size_t{trace.scene().width} * trace.scene().height);
  VirtualPlatform platform(config, image, descriptor);
  platform.unit.observe(&pixels);
  sc_core::sc_start();

  const Processor& processor = platform.processor;
  if (!processor.complaint.empty()) throw std::runtime_error(processor.complaint);
  FrameOutcome outcome = outcome_of(trace.scene(), frame, platform.unit.result());
  outcome.pixels = std::move(pixels);
  take_pixels(processor, image.at<hw::FrameDescriptor>(descriptor).pitch, outcome);
  write_png(argv[2], frame_picture(outcome));

  CheckResult check;
  compare_frame(ref::Golden(trace.scene(), golden_settings(config)).render(frame), outcome, check);
  fmt::print("{}: {} cycles, {:.0f} ns from the start to the interrupt\n", argv[1], processor.cycles,
             processor.frame_time.to_seconds() * 1e9);
  fmt::print("the unit read {} lines and wrote {} over TLM\n", platform.ram.reads(), platform.ram.writes());
  fmt::print("{} pixels compared with the golden model, {} differing\n", check.pixels, check.differing_pixels);
  if (!check.passed()) fmt::print("{}", describe(check));
  return check.passed() ? exit_fine : exit_mismatch;
}

}  // namespace
}  // namespace artu::sim

int main(int argc, char** argv) {
  return artu::sim::exit_code_of([&] { return artu::sim::run(argc, argv); });
}
