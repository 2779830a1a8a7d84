// The unit: instantiates its blocks and binds them, nothing else.  `run` is the host's side of a frame.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hw/control_unit.h"
#include "hw/fabric/sampler.h"
#include "hw/memory/dram.h"
#include "hw/memory/interconnect.h"
#include "hw/ray_core/dispatcher.h"
#include "hw/ray_core/ray_core.h"
#include "hw/run_mode.h"
#include "hw/selective/candidate_pixel_extractor.h"
#include "hw/selective/collision_counter.h"
#include "hw/selective/first_rendering_unit.h"
#include "hw/selective/render_executor.h"
#include "hw/selective/threshold_adjuster.h"

namespace artu::hw {

class ActivitySink;
class UnitWatch;
struct ActivityWindow;

struct FrameResult {
  Cycle cycles = 0;  // of the unit's clock
  bool dead_locked = false;
  std::string picture;                  // dead-lock: who waits for whom
  std::vector<std::string> violations;  // of the accounting laws
  Statistics statistics;
  FrameTimeline timeline;  // where the mode asks for it
};

class RayTracingUnit : public sc_core::sc_module {
 public:
  /// `make_memory`: what stands below the L2; {}: the built-in DRAM.
  RayTracingUnit(sc_core::sc_module_name name, const UnitConfig& config, const RunMode& mode, MemoryImage& image,
                 const Fault& fault = {}, const MakeMemory& make_memory = {});
  ~RayTracingUnit() override;

  /// Renders the frame whose descriptor lies at `descriptor`.  `records` (width * height) may be null.
  FrameResult run(Address descriptor, PixelRecords* records);

  /// In a platform that simulates by itself: the unit keeps to SystemC's time, a frame starts at the present time, and
  /// `at_end` says that it is over (it may do so twice).
  void keep_to_kernel_time(std::function<void()> at_end);
  void begin_frame(Address descriptor, PixelRecords* records);
  FrameResult end_frame();

  /// `sinks`, which must outlive the unit, are told what goes on in the window of every frame from now on.
  void watch(const std::vector<ActivitySink*>& sinks, const ActivityWindow& window);
  std::uint32_t clock_mhz() const { return config_.clock_mhz; }

  /// Every number that the blocks count, in a fixed order.
  Statistics statistics();

  /// Of all blocks, in the order of the reports.
  std::vector<std::string> block_paths() const;

 private:
  void make_l2();
  Block& below_l2();
  void bind_memory();
  void bind_selective();
  void bind_overlap();
  void bind_cores();
  void bind_control();
  void inject(const Fault& fault);
  void make_sampler();
  void each_block(const std::function<void(Block&)>& visit);
  void check_laws(FrameResult& result, const PixelRecords* records) const;
  std::string picture_of_dead_lock() const;

  const UnitConfig config_;
  const RunMode mode_;
  MemoryImage& image_;
  FrameRegisters registers_;
  Timeline timeline_;
  Tick unit_period_ = 1, dram_period_ = 1;
  double tick_seconds_ = 0;
  PixelRecords* records_ = nullptr;

 public:
  ClockDomain clock, dram_clock;
  ControlUnit control_unit;
  FirstRenderingUnit first_rendering_unit;
  Cache pixel_cache;
  CandidatePixelExtractor candidate_pixel_extractor;
  CollisionCounter collision_counter;
  ThresholdAdjuster threshold_adjuster;
  RenderExecutor render_executor;
  Dispatcher dispatcher;
  std::vector<std::unique_ptr<RayCore>> cores;
  FrameWriter frame_writer;
  TreeBuilder tree_builder;
  Interconnect interconnect;
  std::vector<std::unique_ptr<Cache>> l2;    // banks
  std::unique_ptr<Interconnect> l2_to_dram;  // with several banks
  const std::unique_ptr<MainMemory> main_memory;
  MainMemory& dram;  // the same; whatever it is, its clock and its place in the reports are the DRAM's

 private:
  Fifo<PassCommand> first_command_, extract_command_;
  Fifo<PassSize> pass_, written_;
  Fifo<BuildToken> build_, built_;
  Fifo<PixelJob> sampling_jobs_, traced_jobs_;
  Fifo<Candidate> extracted_, counted_, adjusted_;
  Fifo<PixelToken> interpolated_;
  Fifo<LineWritten> visible_, finished_;  // with overlap
  std::vector<std::unique_ptr<Fifo<PixelJob>>> core_jobs_;
  std::vector<std::unique_ptr<Fifo<PixelToken>>> core_pixels_;
  std::vector<std::unique_ptr<Fifo<TreeBuilt>>> tree_built_;  // with overlap
  MemoryLink pixel_reads_, pixel_misses_, descriptor_reads_, frame_writes_, builder_link_, dram_link_;
  struct Bank {
    MemoryLink up, down;
    Fifo<CacheCommand> flush, flushed;
  };
  std::vector<std::unique_ptr<Bank>> banks_;
  std::vector<Channel*> channels_;
  std::unique_ptr<ClockDomain> sampler_clock_;
  std::unique_ptr<Sampler> sampler_;
  std::unique_ptr<UnitWatch> watch_;  // where somebody watches
};

}  // namespace artu::hw
