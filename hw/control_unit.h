// Sequences a frame: descriptor, tree build, first pass, selective passes, write-back (patent, control unit; [0076]).
//
// In:  start; lines of the descriptor and the lights; `built`, `written`, `flushed`.
// Out: commands to the tree builder, the first rendering unit, the candidate-pixel extractor, the frame writer and
//      the L2; the frame registers.
// A pass begins when all pixels of the one before are in memory: that is how the hazards between passes are resolved.
// With `selective.overlap` all passes begin at once: the candidate-pixel extractor knows what is finished.  The phase
// is `first` until the last sampling pixel has come to the frame writer, and `selective` from then on. With
// `tree_builder.overlap` the first pass begins with the build: rays that need the dynamic tree wait in traversal, and
// the control unit tells the cores when it is there.  The write-back waits for the build; what it waits is counted as
// `build`. Not started: building where there is no dynamic geometry or it has not moved; passes without pixels.
#pragma once

#include <functional>

#include "hw/fabric/memory_port.h"
#include "hw/frame_registers.h"
#include "hw/memory/cache.h"
#include "hw/memory/frame_writer.h"
#include "hw/memory/image.h"
#include "hw/memory/tree_builder.h"
#include "hw/ray_core/ray_context.h"
#include "hw/selective/pass_plan.h"
#include "hw/selective/tokens.h"

namespace artu::hw {

class ControlUnit : public Block {
 public:
  ControlUnit(sc_core::sc_module_name name, ClockDomain& domain, const SelectiveConfig& selective,
              const ShadingConfig& shading, FrameRegisters& registers, const MemoryImage& image)
      : Block(name, domain),
        plan_(selective),
        tile_(selective.tile),
        overlap_(selective.overlaps()),
        shading_(shading),
        registers_(registers),
        image_(image) {}

  struct Ports {
    MemoryLink* memory;
    Fifo<BuildToken>* build;
    Fifo<BuildToken>* built;
    Fifo<PassCommand>* first;
    Fifo<PassCommand>* extract;
    Fifo<PassSize>* pass;
    Fifo<PassSize>* written;
    std::vector<Fifo<CacheCommand>*> flush, flushed;  // of the L2's banks
    std::vector<Fifo<TreeBuilt>*> tree_built = {};    // of the cores; none: no overlap
  };
  void bind(const Ports& ports) { ports_ = ports; }
  /// Blocks that are told of a change of phase.
  void add_listener(Block& block) { listeners_.push_back(&block); }

  /// Where the next frame's descriptor lies; read at reset.
  void set_descriptor(Address descriptor) { descriptor_ = descriptor; }
  /// Told when a phase begins.
  void observe_phases(std::function<void(Phase, Cycle)> observer) { phase_observer_ = std::move(observer); }
  /// From the present cycle on.
  Phase phase() const { return phase_; }
  /// The cycle in which the frame was complete; `never` before.
  Cycle finished_at() const { return finished_at_; }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;

 private:
  enum class Step : std::uint8_t { fetch, build, pass, tree, flush, finished };
  Activity tick(Cycle now) override;
  bool fetch();
  bool collect_built();
  void begin_flush(Cycle now);
  bool collect_flushed();
  void enter(Phase phase, Cycle now);
  void begin_pass(std::uint32_t pass, Cycle now);
  bool begin_all_passes(Cycle now);
  std::uint64_t pixels_of(std::uint32_t pass) const;

  const PassPlan plan_;
  const std::uint32_t tile_;
  const bool overlap_;
  const ShadingConfig shading_;
  FrameRegisters& registers_;
  const MemoryImage& image_;
  Ports ports_{};
  std::vector<Block*> listeners_;
  std::function<void(Phase, Cycle)> phase_observer_;
  Address descriptor_ = 0;
  Step step_ = Step::fetch;
  bool building_ = false;
  std::size_t banks_flushed_ = 0;
  std::uint32_t pass_ = 0;
  std::uint64_t lines_ = 0, issued_ = 0, answered_ = 0;
  Cycle finished_at_ = never, phase_began_ = 0;
  Phase phase_ = phase_start;
  std::uint64_t builds_skipped_ = 0;
  std::uint64_t cycles_start_ = 0, cycles_build_ = 0, cycles_first_ = 0, cycles_selective_ = 0, cycles_flush_ = 0;
};

}  // namespace artu::hw
