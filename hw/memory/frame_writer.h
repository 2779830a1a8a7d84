// Writes finished pixels to the frame buffer and the hit-class map, combining writes to the same line.
//
// In:  pixels from every ray core and from the render executor, round-robin, one a cycle; from the control
//      unit how many pixels the pass has.
// Out: line writes; to the control unit `done` when all pixels of the pass are written and acknowledged.
// Latency: a line is written when its entry is needed (the oldest goes first), or at the end of the pass.
// Stalls: stall_mem when an entry must go and the request channel is full.
#pragma once

#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/fabric/round_robin.h"
#include "hw/frame_registers.h"
#include "hw/memory/image.h"

namespace artu::hw {

/// A finished pixel: 16 + 16 bits position, 24 bits colour, 2 bits hit class.
struct PixelToken {
  std::uint16_t x = 0, y = 0;
  std::uint8_t r = 0, g = 0, b = 0;
  HitClass hit_class = HitClass::none;
};

struct PassSize {
  std::uint64_t pixels = 0;
};

class FrameWriter : public Block {
 public:
  FrameWriter(sc_core::sc_module_name name, ClockDomain& domain, const FrameRegisters& registers, MemoryImage& image,
              std::uint32_t entries);
  void add_source(Fifo<PixelToken>& source) { sources_.push_back(&source); }
  /// After the last source.
  void flag_sources();
  void bind(MemoryLink& memory, Fifo<PassSize>& pass, Fifo<PassSize>& done) {
    memory_ = &memory;
    pass_ = &pass;
    done_ = &done;
  }
  /// The pixels' records, for the observer.
  void observe(PixelRecords* records) { records_ = records; }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;

 private:
  struct Entry {
    Address line = 0;
    std::uint64_t bytes = 0;  // 0: free
    std::uint64_t age = 0;
  };
  Activity tick(Cycle now) override;
  bool write(const PixelToken& pixel, Cycle now);
  bool reserve(Address line);
  bool evict(Entry& entry);
  void combine(Address address, std::uint64_t bytes);

  const FrameRegisters& registers_;
  MemoryImage& image_;
  std::vector<Fifo<PixelToken>*> sources_;
  MemoryLink* memory_ = nullptr;
  Fifo<PassSize>* pass_ = nullptr;
  Fifo<PassSize>* done_ = nullptr;
  PixelRecords* records_ = nullptr;
  std::vector<Entry> entries_;
  std::vector<std::uint64_t> waiting_;  // a bit a source
  RoundRobin arbiter_;
  std::uint64_t clock_ = 0;
  bool active_ = false;
  std::uint64_t expected_ = 0, seen_ = 0;
  std::uint32_t unacknowledged_ = 0;
  std::uint64_t pixels_ = 0, line_writes_ = 0;
};

}  // namespace artu::hw
