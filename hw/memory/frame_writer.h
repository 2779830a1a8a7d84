// Writes finished pixels to the frame buffer and the hit-class map, combining writes to the same line.
//
// In:  pixels from every ray core and from the render executor, round-robin, one a cycle; from the control
//      unit how many pixels the pass has.
// Out: line writes; to the control unit `done` when all pixels of the pass are written and acknowledged.
// Latency: a line is written when its entry is needed (the oldest goes first), or at the end of the pass.
// Stalls: stall_mem when an entry must go and the request channel is full.
//
// With overlap the frame is one pass to it, and what a later pass reads is `visible` when its line is acknowledged.  So
// that nobody waits for a pixel that is only held back, an entry goes as well, one a cycle, when all pixels of a pass
// in its line and a tile are there, or when it has not been touched for `patience` cycles.  It keeps which bytes were
// in the writes under way, at most `most_writes` then.  And `done` is said when all sampling pixels have come, before.
#pragma once

#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/fabric/round_robin.h"
#include "hw/frame_registers.h"
#include "hw/memory/cache.h"
#include "hw/memory/image.h"
#include "hw/memory/write_combiner.h"
#include "hw/selective/pass_plan.h"

namespace artu::hw {

/// A finished pixel: 16 + 16 bits position, 24 bits colour, 2 bits hit class.
struct PixelToken {
  std::uint16_t x = 0, y = 0;
  std::uint8_t r = 0, g = 0, b = 0;
  HitClass hit_class = HitClass::none;
};

struct PassSize {
  std::uint64_t pixels = 0;
  std::uint64_t sampling = 0;  // of them those whose end is told as well; 0: it is not
};

class FrameWriter : public Block {
 public:
  static constexpr Cycle patience = 256;
  static constexpr std::uint32_t most_writes = 32;

  FrameWriter(sc_core::sc_module_name name, ClockDomain& domain, const SelectiveConfig& selective,
              const FrameRegisters& registers, MemoryImage& image, std::uint32_t entries);
  void add_source(Fifo<PixelToken>& source) { sources_.push_back(&source); }
  /// After the last source.
  void flag_sources();
  void bind(MemoryLink& memory, Fifo<PassSize>& pass, Fifo<PassSize>& done) {
    memory_ = &memory;
    pass_ = &pass;
    done_ = &done;
  }
  /// With overlap.
  void bind_visible(Fifo<LineWritten>& visible) { visible_ = &visible; }
  /// The pixels' records, for the observer.
  void observe(PixelRecords* records) { records_ = records; }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;

 private:
  using Entry = WriteCombiner::Entry;
  Activity tick(Cycle now) override;
  bool acknowledge();
  bool tell_sampling();
  bool send_due(Cycle now, bool& blocked);
  Cycle next_due(Cycle now) const;
  bool write(const PixelToken& pixel, Cycle now);
  bool reserve(Address line);
  bool evict(Entry& entry);
  bool combine(const PixelToken& pixel, Address color, Address hit_class, Cycle now);
  /// For every pass the bytes of its pixels in a line that begins where a tile does.
  struct Grid {
    Grid(const PassPlan& plan, std::uint32_t bytes);
    std::uint32_t bytes_a_pixel;
    std::vector<std::uint64_t> of_pass;
  };
  void note(const PixelToken& pixel, std::uint32_t pass, Entry& entry, std::uint64_t bytes, const Grid& grid);
  std::uint64_t expected_in(const PixelToken& pixel, std::uint32_t pass, const Grid& grid) const;
  std::uint32_t last_pass() const;

  const PassPlan plan_;
  const std::uint32_t tile_;
  const FrameRegisters& registers_;
  MemoryImage& image_;
  const Grid colors_, classes_;
  std::vector<Fifo<PixelToken>*> sources_;
  MemoryLink* memory_ = nullptr;
  Fifo<PassSize>* pass_ = nullptr;
  Fifo<PassSize>* done_ = nullptr;
  PixelRecords* records_ = nullptr;
  Fifo<LineWritten>* visible_ = nullptr;
  WriteCombiner lines_;
  std::vector<std::uint64_t> waiting_;  // a bit a source
  RoundRobin arbiter_;
  bool active_ = false, evicted_ = false;
  PassSize pass_size_{};
  std::uint64_t seen_ = 0, sampling_left_ = 0;
  bool sampling_told_ = true;
  std::uint32_t last_pass_ = 0;         // that has a pixel
  std::vector<LineWritten> under_way_;  // by the tag of the write, with overlap
  std::vector<std::uint32_t> free_tags_;
  std::uint32_t unacknowledged_ = 0;
  std::uint64_t pixels_ = 0, line_writes_ = 0;
};

}  // namespace artu::hw
