#include "hw/ray_tracing_unit.h"

#include <numeric>

#include "hw/watch/unit_watch.h"

namespace artu::hw {

namespace {
constexpr std::uint32_t job_depth = 8;

/// A bank's share.
CacheConfig bank_of(const MemoryConfig& memory) {
  CacheConfig bank = memory.l2;
  bank.size /= memory.l2_banks;
  bank.mshrs = (bank.mshrs + memory.l2_banks - 1) / memory.l2_banks;
  return bank;
}

Tick period_of(std::uint32_t own_mhz, std::uint32_t other_mhz) { return other_mhz / std::gcd(own_mhz, other_mhz); }
}  // namespace

RayTracingUnit::RayTracingUnit(sc_core::sc_module_name name, const UnitConfig& config, const RunMode& mode,
                               MemoryImage& image, const Fault& fault, const MakeMemory& make_memory)
    : sc_module(name),
      config_(config),
      mode_(mode),
      image_(image),
      unit_period_(period_of(config.clock_mhz, config.memory.dram.clock_mhz)),
      dram_period_(period_of(config.memory.dram.clock_mhz, config.clock_mhz)),
      tick_seconds_(1.0e-6 / (static_cast<double>(config.clock_mhz) * static_cast<double>(unit_period_))),
      clock("clock", timeline_, unit_period_, tick_seconds_),
      dram_clock("dram_clock", timeline_, dram_period_, tick_seconds_),
      control_unit("control_unit", clock, config.selective, config.shading, registers_, image),
      first_rendering_unit("first_rendering_unit", clock, config.selective, registers_, config.core.pixel_order),
      pixel_cache("pixel_cache", clock, config.selective.pixel_cache),
      candidate_pixel_extractor("candidate_pixel_extractor", clock, config.selective, registers_, image, pixel_cache),
      collision_counter("collision_counter", clock),
      threshold_adjuster("threshold_adjuster", clock, config.selective),
      render_executor("render_executor", clock, config.selective.metric, registers_),
      dispatcher("dispatcher", clock, registers_, config.core.dispatch, config.selective.tile),
      frame_writer("frame_writer", clock, config.selective, registers_, image, config.memory.write_combining),
      tree_builder("tree_builder", clock, config.tree_builder, registers_),
      interconnect("interconnect", clock),
      main_memory(make_memory ? make_memory(dram_clock)
                              : std::make_unique<Dram>("dram", dram_clock, config.memory.dram)),
      dram(*main_memory),
      first_command_("first_command", 2),
      extract_command_("extract_command", 2),
      pass_("pass", 2),
      written_("written", 2),
      build_("build", 2),
      built_("built", 2),
      sampling_jobs_("sampling_jobs", job_depth),
      traced_jobs_("traced_jobs", job_depth),
      extracted_("extracted", 4),
      counted_("counted", 2 + CollisionCounter::latency, CollisionCounter::latency),
      adjusted_("adjusted", 2 + ThresholdAdjuster::latency(config.selective),
                ThresholdAdjuster::latency(config.selective)),
      interpolated_("interpolated", job_depth),
      visible_("visible", 4),
      finished_("finished", 4),
      pixel_reads_("pixel_reads", 4, 1, config.selective.pixel_cache.hit_latency),
      pixel_misses_("pixel_misses", config.selective.pixel_cache.mshrs, config.memory.interconnect_latency,
                    config.memory.interconnect_latency),
      descriptor_reads_("descriptor_reads", 4, config.memory.interconnect_latency, config.memory.interconnect_latency),
      frame_writes_("frame_writes", 4, config.memory.interconnect_latency, config.memory.interconnect_latency),
      builder_link_("builder", config.tree_builder.outstanding, config.memory.interconnect_latency,
                    config.memory.interconnect_latency),
      dram_link_("dram", 2 * config.memory.l2.mshrs, 1, 1) {
  registers_.skip = config.skip;
  for (std::uint32_t i = 0; i < config.core.count; ++i) {
    const std::string core = "core" + std::to_string(i);
    cores.push_back(std::make_unique<RayCore>(core.c_str(), clock, config, registers_, image, i));
    core_jobs_.push_back(std::make_unique<Fifo<PixelJob>>(core + ".jobs", config.core.queue_depth + 1));
    if (config.tree_builder.overlap) tree_built_.push_back(std::make_unique<Fifo<TreeBuilt>>(core + ".tree_built", 2));
    core_pixels_.push_back(std::make_unique<Fifo<PixelToken>>(core + ".pixels", config.core.queue_depth + 1));
  }
  make_l2();
  bind_memory();
  bind_selective();
  bind_cores();
  bind_control();
  if (config.selective.overlaps()) bind_overlap();
  interconnect.flag_channels();
  frame_writer.flag_sources();
  inject(fault);
  if (mode.random_stall) {
    std::uint64_t number = 0;
    for (Channel* channel : channels_) channel->stall_randomly(mode.seed * 1000003 + ++number);
  }
  for (ClockDomain* domain : timeline_.domains) {
    domain->set_clocked(mode.clocked);
    domain->set_shuffle(mode.shuffle, mode.seed);
  }
  clock.set_watchdog(config.watchdog);
  if (mode.timeline) make_sampler();
  each_block([this](Block& block) {
    for (const LogRule& rule : mode_.log) {
      if (fits(rule, block.path())) block.log_to(rule.level, mode_.log_sink);
    }
  });
}

RayTracingUnit::~RayTracingUnit() = default;

/// The last domain: of those that have an edge at the same time it is worked on last.
void RayTracingUnit::make_sampler() {
  std::vector<const Block*> blocks;
  each_block([&](const Block& block) { blocks.push_back(&block); });
  const auto rays = [this](auto&& of) {
    return [this, of] {
      std::uint64_t sum = 0;
      for (const auto& core : cores) {
        for (std::size_t kind = 0; kind < ray_kinds; ++kind) sum += of(*core, static_cast<RayKind>(kind));
      }
      return sum;
    };
  };
  std::vector<Sampler::Count> counts{
      {"read_bytes", [this] { return dram.read_bytes(); }},
      {"write_bytes", [this] { return dram.write_bytes(); }},
      {"rays_begun", rays([](const RayCore& core, RayKind kind) { return core.ray_generator.rays(kind); })},
      {"rays_finished", rays([](const RayCore& core, RayKind kind) { return core.traversal.finished(kind); })}};
  sampler_clock_ =
      std::make_unique<ClockDomain>("sampler_clock", timeline_, unit_period_ * Sampler::first_interval, tick_seconds_);
  sampler_ =
      std::make_unique<Sampler>("sampler", *sampler_clock_, unit_period_, std::move(blocks),
                                std::vector<const Channel*>(channels_.begin(), channels_.end()), std::move(counts));
  control_unit.observe_phases([this](Phase phase, Cycle cycle) { sampler_->phase_begins(phase, cycle); });
}

/// One cache, or with several banks as many, and a crossbar between them and the DRAM.
void RayTracingUnit::make_l2() {
  const MemoryConfig& memory = config_.memory;
  const std::uint32_t count = memory.l2_banks;
  const CacheConfig share = bank_of(memory);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string name = count == 1 ? "l2" : "l2_bank" + std::to_string(i);
    l2.push_back(std::make_unique<Cache>(name.c_str(), clock, share, count));
    banks_.push_back(std::unique_ptr<Bank>(new Bank{{name, 4, 1, share.hit_latency},
                                                    {name + "_misses", 2 * share.mshrs, 1, 1},
                                                    {name + ".flush", 2},
                                                    {name + ".flushed", 2}}));
  }
  if (count > 1) l2_to_dram = std::make_unique<Interconnect>("l2_to_dram", clock);
}

Block& RayTracingUnit::below_l2() { return l2_to_dram ? static_cast<Block&>(*l2_to_dram) : *l2[0]; }

void RayTracingUnit::bind_memory() {
  pixel_reads_.bind(candidate_pixel_extractor, pixel_cache);
  pixel_cache.add_client(pixel_reads_);
  pixel_misses_.bind(pixel_cache, interconnect);
  pixel_cache.bind_below(pixel_misses_);
  descriptor_reads_.bind(control_unit, interconnect);
  frame_writes_.bind(frame_writer, interconnect);
  builder_link_.bind(tree_builder, interconnect);
  for (MemoryLink* link : {&descriptor_reads_, &builder_link_, &frame_writes_, &pixel_misses_}) {
    interconnect.add_master(*link);
  }
  dram_link_.bind(below_l2(), dram);
  dram.bind(dram_link_);
  for (std::size_t i = 0; i < l2.size(); ++i) {
    Bank& bank = *banks_[i];
    bank.up.bind(interconnect, *l2[i]);
    interconnect.add_memory(bank.up);
    l2[i]->add_client(bank.up);
    bank.flush.bind(control_unit, *l2[i]);
    bank.flushed.bind(*l2[i], control_unit);
    l2[i]->bind_flush(bank.flush, bank.flushed);
    if (l2_to_dram) {
      bank.down.bind(*l2[i], *l2_to_dram);
      l2_to_dram->add_master(bank.down);
    }
    l2[i]->bind_below(l2_to_dram ? bank.down : dram_link_);
    for (Channel* channel :
         std::initializer_list<Channel*>{&bank.up.request, &bank.up.response, &bank.flush, &bank.flushed}) {
      channels_.push_back(channel);
    }
    if (l2_to_dram) channels_.insert(channels_.end(), {&bank.down.request, &bank.down.response});
  }
  if (l2_to_dram) {
    l2_to_dram->add_memory(dram_link_);
    l2_to_dram->flag_channels();
  }
  for (MemoryLink* link :
       {&pixel_reads_, &pixel_misses_, &descriptor_reads_, &frame_writes_, &builder_link_, &dram_link_}) {
    channels_.push_back(&link->request);
    channels_.push_back(&link->response);
  }
}

void RayTracingUnit::bind_selective() {
  first_command_.bind(control_unit, first_rendering_unit);
  extract_command_.bind(control_unit, candidate_pixel_extractor);
  sampling_jobs_.bind(first_rendering_unit, dispatcher);
  extracted_.bind(candidate_pixel_extractor, collision_counter);
  counted_.bind(collision_counter, threshold_adjuster);
  adjusted_.bind(threshold_adjuster, render_executor);
  interpolated_.bind(render_executor, frame_writer);
  traced_jobs_.bind(render_executor, dispatcher);
  first_rendering_unit.bind(first_command_, sampling_jobs_);
  candidate_pixel_extractor.bind(extract_command_, extracted_, pixel_reads_);
  collision_counter.bind(extracted_, counted_);
  threshold_adjuster.bind(counted_, adjusted_);
  render_executor.bind(adjusted_, interpolated_, traced_jobs_);
  for (Channel* channel :
       std::initializer_list<Channel*>{&first_command_, &extract_command_, &sampling_jobs_, &extracted_, &counted_,
                                       &adjusted_, &interpolated_, &traced_jobs_}) {
    channels_.push_back(channel);
  }
}

/// Passes that overlap: what the L2 has of the frame goes to the pixel cache, which forgets it, and to the scoreboard.
void RayTracingUnit::bind_overlap() {
  visible_.bind(frame_writer, pixel_cache);
  finished_.bind(pixel_cache, candidate_pixel_extractor);
  frame_writer.bind_visible(visible_);
  pixel_cache.bind_written(visible_, finished_);
  candidate_pixel_extractor.bind_finished(finished_);
  channels_.push_back(&visible_);
  channels_.push_back(&finished_);
}

void RayTracingUnit::bind_cores() {
  dispatcher.add_source(sampling_jobs_);
  dispatcher.add_source(traced_jobs_);
  for (std::size_t i = 0; i < cores.size(); ++i) {
    RayCore& core = *cores[i];
    core_jobs_[i]->bind(dispatcher, core.ray_generator);
    core_pixels_[i]->bind(core.shading, frame_writer);
    dispatcher.add_core(*core_jobs_[i]);
    frame_writer.add_source(*core_pixels_[i]);
    Fifo<TreeBuilt>* built = tree_built_.empty() ? nullptr : tree_built_[i].get();
    if (built != nullptr) {
      built->bind(control_unit, core.traversal);
      channels_.push_back(built);
    }
    core.bind(interconnect, *core_jobs_[i], *core_pixels_[i], built);
    channels_.push_back(core_jobs_[i].get());
    channels_.push_back(core_pixels_[i].get());
    channels_.insert(channels_.end(), core.channels().begin(), core.channels().end());
  }
  frame_writer.add_source(interpolated_);
}

void RayTracingUnit::bind_control() {
  pass_.bind(control_unit, frame_writer);
  written_.bind(frame_writer, control_unit);
  build_.bind(control_unit, tree_builder);
  built_.bind(tree_builder, control_unit);
  frame_writer.bind(frame_writes_, pass_, written_);
  tree_builder.bind(builder_link_, build_, built_);
  ControlUnit::Ports ports{&descriptor_reads_, &build_, &built_, &first_command_, &extract_command_, &pass_,
                           &written_,          {},      {}};
  for (const auto& bank : banks_) {
    ports.flush.push_back(&bank->flush);
    ports.flushed.push_back(&bank->flushed);
  }
  for (const auto& core : tree_built_) ports.tree_built.push_back(core.get());
  control_unit.bind(ports);
  for (Channel* channel : std::initializer_list<Channel*>{&pass_, &written_, &build_, &built_}) {
    channels_.push_back(channel);
  }
  tree_builder.takes_part_in(config_.tree_builder.overlap ? phase_build | phase_first | phase_selective : phase_build);
  first_rendering_unit.takes_part_in(phase_first);
  for (Block* block : std::initializer_list<Block*>{&pixel_cache, &candidate_pixel_extractor, &collision_counter,
                                                    &threshold_adjuster, &render_executor}) {
    block->takes_part_in(config_.selective.overlaps() ? phase_first | phase_selective : phase_selective);
  }
  dispatcher.takes_part_in(phase_first | phase_selective);
  frame_writer.takes_part_in(phase_first | phase_selective);
  for (Block* block : clock.blocks()) {
    if (block != &control_unit) control_unit.add_listener(*block);
  }
}

void RayTracingUnit::inject(const Fault& fault) {
  const std::uint32_t bits = 1u << (fault.bit & 31);
  const auto code = static_cast<std::uint8_t>(1u << (fault.bit & 7));
  for (auto& core : cores) {
    if (fault.datapath == Datapath::box) core->traversal.inject(bits);
    if (fault.datapath == Datapath::triangle) core->intersection.inject(bits);
    if (fault.datapath == Datapath::shading) core->shading.inject(code);
  }
  if (auto* built_in = dynamic_cast<Dram*>(main_memory.get());
      built_in != nullptr && fault.datapath == Datapath::dram) {
    built_in->lose(fault.bit);
  }
  if (fault.datapath == Datapath::interpolation) render_executor.inject(code);
  if (fault.datapath == Datapath::threshold) threshold_adjuster.inject(code);
}

FrameResult RayTracingUnit::run(Address descriptor, PixelRecords* records) {
  begin_frame(descriptor, records);
  sc_core::sc_start();
  return end_frame();
}

void RayTracingUnit::keep_to_kernel_time(std::function<void()> at_end) {
  timeline_.in_step = true;
  timeline_.at_end = std::move(at_end);
}

void RayTracingUnit::begin_frame(Address descriptor, PixelRecords* records) {
  records_ = records;
  for (Channel* channel : channels_) channel->reset();
  timeline_.now = 0;
  control_unit.set_descriptor(descriptor);
  first_rendering_unit.observe(records);
  render_executor.observe(records);
  dispatcher.observe(records);
  frame_writer.observe(records);
  for (auto& core : cores) core->shading.observe(records);
  if (watch_) watch_->begin_frame();
  for (ClockDomain* domain : timeline_.domains) domain->begin_frame();
}

FrameResult RayTracingUnit::end_frame() {
  FrameResult result;
  if (control_unit.finished_at() == never) {
    result.dead_locked = true;
    result.picture = picture_of_dead_lock();
    return result;
  }
  result.cycles = control_unit.finished_at();
  if (sampler_) {
    sampler_->finish(result.cycles);
    result.timeline = sampler_->timeline();
  }
  if (watch_) watch_->end_frame(result.cycles * unit_period_);
  clock.end_frame(result.cycles);
  dram_clock.end_frame(result.cycles * unit_period_ / dram_period_);
  result.statistics = statistics();
  check_laws(result, records_);
  return result;
}

void RayTracingUnit::watch(const std::vector<ActivitySink*>& sinks, const ActivityWindow& window) {
  watch_ = std::make_unique<UnitWatch>(*this, sinks, window);
  timeline_.observer = watch_.get();
}

Statistics RayTracingUnit::statistics() {
  Statistics all;
  each_block([&](Block& block) {
    static const char* const texts[state_count] = {"worked, or had work in its pipeline", "starved: no input",
                                                   "blocked by a full channel", "waited for memory",
                                                   "no part in this phase of the frame"};
    const std::string unit = &block == &dram ? "DRAM clocks" : "cycles";
    for (std::size_t s = 0; s < state_count; ++s) {
      all.push_back(
          {block.path(), state_name(static_cast<State>(s)), block.cycles_in(static_cast<State>(s)), unit, texts[s]});
    }
    block.report(all);
  });
  return all;
}

void RayTracingUnit::each_block(const std::function<void(Block&)>& visit) {
  for (Block* block : clock.blocks()) visit(*block);
  for (Block* block : dram_clock.blocks()) visit(*block);
}

std::vector<std::string> RayTracingUnit::block_paths() const {
  std::vector<std::string> paths;
  for (const ClockDomain* domain : {&clock, &dram_clock}) {
    for (const Block* block : domain->blocks()) paths.push_back(block->path());
  }
  return paths;
}

std::string RayTracingUnit::picture_of_dead_lock() const {
  std::string text = "dead-lock in cycle " + std::to_string(clock.now()) + ": no token moves\n";
  for (const ClockDomain* domain : timeline_.domains) {
    for (const Block* block : domain->blocks()) {
      const std::string detail = block->describe();
      if (block->state() == State::idle && detail.empty()) continue;
      text += "  " + block->path() + ": " + state_name(block->state());
      if (!detail.empty()) text += "; " + detail;
      text += "\n";
    }
  }
  for (const Channel* channel : channels_) {
    if (channel->size() == 0) continue;
    text += "  channel " + channel->name() + ": " + std::to_string(channel->size()) + " of " +
            std::to_string(channel->capacity()) + ", from " + channel->producer()->path() + " to " +
            channel->consumer()->path() + "\n";
  }
  return text;
}

}  // namespace artu::hw
