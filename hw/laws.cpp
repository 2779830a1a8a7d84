// The accounting laws, checked at the end of every frame (docs/architecture.md).
#include "hw/ray_tracing_unit.h"

namespace artu::hw {

namespace {

/// Collects the laws that do not hold.
class Laws {
 public:
  explicit Laws(std::vector<std::string>& violations) : violations_(violations) {}
  void equal(const std::string& left, std::uint64_t a, const std::string& right, std::uint64_t b) {
    if (a != b)
      violations_.push_back(left + " (" + std::to_string(a) + ") != " + right + " (" + std::to_string(b) + ")");
  }

 private:
  std::vector<std::string>& violations_;
};

std::uint64_t all_cycles(const Block& block) {
  std::uint64_t sum = 0;
  for (std::size_t s = 0; s < state_count; ++s) sum += block.cycles_in(static_cast<State>(s));
  return sum;
}

}  // namespace

void RayTracingUnit::check_laws(FrameResult& result, const PixelRecords* records) const {
  Laws laws(result.violations);
  for (const Block* block : clock.blocks()) {
    laws.equal("cycle classes of " + block->path(), all_cycles(*block), "cycles of the frame", result.cycles);
  }
  for (const Block* block : dram_clock.blocks()) {
    laws.equal("cycle classes of " + block->path(), all_cycles(*block), "DRAM clocks of the frame",
               result.cycles * unit_period_ / dram_period_);
  }
  static const char* const kinds[ray_kinds] = {"primary", "shadow", "reflection", "refraction"};
  std::uint64_t primary = 0;
  for (std::size_t kind = 0; kind < ray_kinds; ++kind) {
    std::uint64_t in = 0, out = 0;
    for (const auto& core : cores) {
      in += core->ray_generator.rays(static_cast<RayKind>(kind));
      out += core->traversal.finished(static_cast<RayKind>(kind));
    }
    laws.equal(std::string(kinds[kind]) + " rays in", in, "rays out", out);
    if (kind == 0) primary = in;
  }
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint64_t pixels = std::uint64_t{frame.width} * frame.height;
  const std::uint64_t sampled =
      PassPlan(config_.selective).walk(0, frame.width, frame.height, config_.selective.tile).pixels();
  laws.equal("candidates", pixels - sampled, "interpolated + traced",
             render_executor.interpolated() + render_executor.traced());
  laws.equal("primary rays", primary, "sampled + traced pixels", sampled + render_executor.traced());
  std::uint64_t fills = 0, write_backs = 0;
  for (const auto& bank : l2) {
    fills += bank->fills();
    write_backs += bank->write_backs();
  }
  laws.equal("bytes read from DRAM", dram.read_bytes(), "lines filled into the L2, in bytes", fills * line_bytes);
  laws.equal("bytes written to DRAM", dram.write_bytes(), "lines written back by the L2, in bytes",
             write_backs * line_bytes);
  if (records != nullptr) {
    std::uint64_t once = 0;
    for (const PixelRecord& record : *records) once += record.written == 1;
    laws.equal("pixels written exactly once", once, "pixels", pixels);
  }
  for (const Channel* channel : channels_) laws.equal("tokens left in " + channel->name(), channel->size(), "none", 0);
}

}  // namespace artu::hw
