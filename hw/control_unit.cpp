#include "hw/control_unit.h"

namespace artu::hw {

void ControlUnit::reset() {
  step_ = Step::fetch;
  pass_ = 0;
  banks_flushed_ = 0;
  building_ = false;
  issued_ = answered_ = 0;
  lines_ = sizeof(FrameDescriptor) / line_bytes;
  finished_at_ = never;
  phase_began_ = 0;
  phase_ = phase_start;
  builds_skipped_ = 0;
  cycles_start_ = cycles_build_ = cycles_first_ = cycles_selective_ = cycles_flush_ = 0;
}

/// Reads the descriptor, then the lights it points to; true when all is in the registers.
bool ControlUnit::fetch() {
  if (ports_.memory->response.can_pop()) {
    ports_.memory->response.pop();
    ++answered_;
    const std::uint64_t descriptor_lines = sizeof(FrameDescriptor) / line_bytes;
    if (answered_ == descriptor_lines) {
      take_descriptor(image_.at<FrameDescriptor>(descriptor_), shading_, registers_);
      take_lights(image_, registers_);
      lines_ = descriptor_lines + registers_.descriptor.light_count;
    }
  }
  if (issued_ < lines_ && ports_.memory->request.can_push()) {
    const std::uint64_t descriptor_lines = sizeof(FrameDescriptor) / line_bytes;
    const Address line = issued_ < descriptor_lines
                             ? descriptor_ + issued_ * line_bytes
                             : registers_.descriptor.lights + (issued_ - descriptor_lines) * line_bytes;
    ports_.memory->request.push({line, 0, 0, 0});
    ++issued_;
  }
  return answered_ == lines_;
}

void ControlUnit::enter(Phase phase, Cycle now) {
  const std::uint64_t elapsed = now - phase_began_;
  switch (phase_) {
    case phase_start:
      cycles_start_ += elapsed;
      break;
    case phase_build:
      cycles_build_ += elapsed;
      break;
    case phase_first:
      cycles_first_ += elapsed;
      break;
    case phase_selective:
      cycles_selective_ += elapsed;
      break;
    case phase_flush:
      cycles_flush_ += elapsed;
      break;
  }
  phase_ = phase;
  phase_began_ = now;
  for (Block* block : listeners_) block->set_phase(phase);
  if (phase_observer_) phase_observer_(phase, now);
}

std::uint64_t ControlUnit::pixels_of(std::uint32_t pass) const {
  const FrameDescriptor& frame = registers_.descriptor;
  return plan_.walk(pass, frame.width, frame.height, tile_).pixels();
}

/// Or the first one after it that has a pixel; after the last one the frame is written back.
void ControlUnit::begin_pass(std::uint32_t pass, Cycle now) {
  if (overlap_ && pass == 0 && begin_all_passes(now)) return;
  while (pass < plan_.passes() && pixels_of(pass) == 0) ++pass;
  pass_ = pass;
  if (pass == plan_.passes()) {
    if (building_) {
      step_ = Step::tree;
      enter(phase_build, now);
    } else {
      begin_flush(now);
    }
    return;
  }
  step_ = Step::pass;
  if (pass == 0) {
    enter(phase_first, now);
  } else if (phase_ != phase_selective) {
    enter(phase_selective, now);
  }
  ports_.pass->push({pixels_of(pass)});
  (pass == 0 ? ports_.first : ports_.extract)
      ->push({static_cast<std::uint8_t>(pass), static_cast<std::uint8_t>(plan_.stride())});
}

/// With overlap; false if there are no candidates, so that there is nothing to overlap.
bool ControlUnit::begin_all_passes(Cycle now) {
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint64_t pixels = std::uint64_t{frame.width} * frame.height, sampling = pixels_of(0);
  if (pixels == sampling) return false;
  pass_ = plan_.passes() - 1;
  step_ = Step::pass;
  enter(phase_first, now);
  ports_.pass->push({pixels, sampling});
  ports_.first->push({0, static_cast<std::uint8_t>(plan_.stride())});
  ports_.extract->push({1, static_cast<std::uint8_t>(plan_.stride()), static_cast<std::uint8_t>(pass_)});
  return true;
}

void ControlUnit::begin_flush(Cycle now) {
  step_ = Step::flush;
  enter(phase_flush, now);
  for (Fifo<CacheCommand>* bank : ports_.flush) bank->push({});
}

/// Whether the builder has finished in this cycle; passed on to the cores.
bool ControlUnit::collect_built() {
  if (!ports_.built->can_pop()) return false;
  ports_.built->pop();
  building_ = false;
  for (Fifo<TreeBuilt>* core : ports_.tree_built) core->push({});
  return true;
}

/// Whether all banks have answered.
bool ControlUnit::collect_flushed() {
  for (Fifo<CacheCommand>* bank : ports_.flushed) {
    if (!bank->can_pop()) continue;
    bank->pop();
    ++banks_flushed_;
  }
  return banks_flushed_ == ports_.flushed.size();
}

Activity ControlUnit::tick(Cycle now) {
  const bool built = collect_built();
  switch (step_) {
    case Step::fetch: {
      const std::uint64_t before = issued_ + answered_;
      if (fetch()) {
        const FrameDescriptor& frame = registers_.descriptor;
        if (registers_.builds()) {
          ports_.build->push({});
          building_ = true;
        } else if (frame.dynamic_triangle_count != 0) {
          ++builds_skipped_;
        }
        if (building_ && ports_.tree_built.empty()) {
          enter(phase_build, now);
          step_ = Step::build;
        } else {
          begin_pass(0, now);
        }
        return {State::busy, now + 1};
      }
      if (issued_ + answered_ != before) return {State::busy, now + 1};
      return {State::stall_mem};
    }
    case Step::build:
      if (!built) return {State::stall_in};
      begin_pass(0, now);
      return {State::busy, now + 1};
    case Step::pass:
      if (ports_.written->can_pop()) {
        const bool sampling_alone = overlap_ && phase_ == phase_first && pass_ != 0;
        ports_.written->pop();
        if (sampling_alone) {
          enter(phase_selective, now);
        } else {
          begin_pass(pass_ + 1, now);
        }
      } else if (!built) {
        return {State::stall_in};
      }
      return {State::busy, now + 1};
    case Step::tree:
      if (!built) return {State::stall_in};
      begin_flush(now);
      return {State::busy, now + 1};
    case Step::flush:
      if (!collect_flushed()) return {State::stall_mem};
      enter(phase_flush, now);
      finished_at_ = now;
      step_ = Step::finished;
      domain().finish();
      return {State::busy};
    case Step::finished:
      break;
  }
  return {State::idle};
}

void ControlUnit::report(Statistics& out) const {
  const std::string block = path();
  out.push_back({block, "cycles_start", cycles_start_, "cycles", "phase: descriptor and lights are read"});
  out.push_back(
      {block, "cycles_build", cycles_build_, "cycles", "phase: the dynamic tree is built and nothing else goes on"});
  out.push_back({block, "cycles_first", cycles_first_, "cycles", "phase: sampling pixels are traced"});
  out.push_back(
      {block, "cycles_selective", cycles_selective_, "cycles", "phase: candidates are interpolated or traced"});
  out.push_back({block, "cycles_flush", cycles_flush_, "cycles", "phase: the frame is written back to DRAM"});
  out.push_back({block, "builds_skipped", builds_skipped_, "frames", "nothing has moved: the dynamic tree was kept"});
}

std::string ControlUnit::describe() const {
  static const char* const names[] = {"reads the descriptor",       "waits for the tree builder",
                                      "waits for the end of pass ", "waits for the tree builder",
                                      "waits for the write-back",   "finished"};
  std::string text = names[static_cast<std::size_t>(step_)];
  if (step_ == Step::pass) text += std::to_string(pass_);
  return text;
}

}  // namespace artu::hw
