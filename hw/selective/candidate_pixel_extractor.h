// Finds the candidate pixels of a pass and fetches what is decided on: colours and hit classes of the neighbours
// (patent, candidate-pixel extraction module 531; C11).
//
// In:  a pass command; lines of the frame buffer and of the hit-class map, through the pixel cache.
// Out: candidates, to the collision counter, in tile order.
// Works on spans (one row of one tile): up to four spans have their lines fetched, one request a cycle, while the
// oldest hands on one candidate a cycle.  A span needs the rows in which earlier passes have finished neighbours: of a
// horizontal pass its own, of a vertical one those above and below, of a centre all three.
// With overlap all passes are open at a time, each at a place of its own, and the latest whose next span finds all that
// it looks at finished goes on: `finished` says which pixels the L2 has, after the pixel cache has forgotten their
// lines. Stalls: stall_in when no pass finds that, stall_mem when the oldest span's lines are awaited, stall_out when
// the collision counter takes no more.
#pragma once

#include <array>
#include <vector>

#include "hw/frame_registers.h"
#include "hw/memory/cache.h"
#include "hw/memory/image.h"
#include "hw/selective/candidate.h"
#include "hw/selective/scoreboard.h"

namespace artu::hw {

class CandidatePixelExtractor : public Block {
 public:
  CandidatePixelExtractor(sc_core::sc_module_name name, ClockDomain& domain, const SelectiveConfig& config,
                          const FrameRegisters& registers, const MemoryImage& image, Cache& pixel_cache)
      : Block(name, domain),
        config_(config),
        plan_(config),
        scoreboard_(plan_, config.tile),
        registers_(registers),
        image_(image),
        pixel_cache_(pixel_cache) {}
  void bind(Fifo<PassCommand>& command, Fifo<Candidate>& out, MemoryLink& memory) {
    command_ = &command;
    out_ = &out;
    memory_ = &memory;
  }

  /// With overlap.
  void bind_finished(Fifo<LineWritten>& finished) { finished_ = &finished; }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;

 private:
  /// A pass, and how far its spans have been opened.
  struct Lane {
    std::uint32_t number;
    Pass pass;
    TileWalk walk;
    std::uint64_t blocked_at;  // version of the scoreboard at which the next span could not be opened
  };
  struct Window {
    std::uint32_t number = 0;  // of the pass
    Pass pass{};
    TileWalk::Span span{};
    std::vector<Address> lines;
    std::size_t issued = 0, answered = 0;
  };
  static constexpr std::size_t windows = 4;

  Activity tick(Cycle now) override;
  void begin(const PassCommand& command);
  Lane* next_lane();
  Area looked_at(const Lane& lane) const;
  void open_window(Lane& lane);
  void want_row(Window& window, std::uint32_t left, std::uint32_t right, std::uint32_t y);

  const SelectiveConfig config_;
  const PassPlan plan_;
  Scoreboard scoreboard_;
  const FrameRegisters& registers_;
  const MemoryImage& image_;
  Cache& pixel_cache_;
  Fifo<PassCommand>* command_ = nullptr;
  Fifo<Candidate>* out_ = nullptr;
  MemoryLink* memory_ = nullptr;
  Fifo<LineWritten>* finished_ = nullptr;
  std::vector<Lane> lanes_;  // passes that have spans left, the latest first
  std::array<Window, windows> window_;
  std::size_t first_ = 0, open_ = 0;  // ring of windows; counts only go up
  std::size_t fetching_ = 0;          // the window whose lines are being requested
  std::uint32_t x_ = 0;               // next candidate of the oldest window
  std::uint64_t candidates_ = 0, spans_ = 0;
};

}  // namespace artu::hw
