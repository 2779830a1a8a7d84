// The passes of a frame without time: FunctionalUnit::run for any listener.
#pragma once

#include "hw/functional/functional_unit.h"
#include "hw/functional/pixel_tracer.h"
#include "hw/selective/candidate.h"
#include "hw/selective/pixel_walk.h"
#include "hw/selective/policy.h"

namespace artu::hw {

template <class Tap>
class FrameRendering {
 public:
  FrameRendering(const UnitConfig& config, const FrameRegisters& registers, MemoryImage& image, bool portable,
                 bool overflows, PixelRecords& records, Tap& tap)
      : config_(config),
        plan_(config.selective),
        policy_(policy(config.selective.policy)),
        frame_(registers.descriptor),
        image_(image),
        records_(records),
        tap_(tap),
        tracer_(config, registers, image, portable, overflows, counts_, tap) {}

  FunctionalCounts run() {
    PixelWalk walk(config_.core.pixel_order, frame_.width, frame_.height, config_.selective.tile, plan_.stride());
    for (; !walk.done(); walk.next()) {
      record(walk.x(), walk.y()).decision = Decision::sampled;
      trace(walk.x(), walk.y(), 0);
      ++counts_.sampled;
    }
    for (std::uint32_t number = 1; number < plan_.passes(); ++number) {
      tap_.begin_pass(number, counts_);
      const Pass pass = plan_.pass(number);
      for (TileWalk walk = plan_.walk(number, frame_.width, frame_.height, config_.selective.tile); !walk.done();
           walk.next()) {
        const TileWalk::Span span = walk.span();
        for (std::uint32_t x = span.begin; x < span.end; x += walk.dx()) decide(pass, number, x, span.y);
      }
    }
    return counts_;
  }

 private:
  PixelRecord& record(std::uint32_t x, std::uint32_t y) { return records_[std::size_t{y} * frame_.width + x]; }

  void store(std::uint32_t x, std::uint32_t y, Rgb color, HitClass hit_class) {
    store_pixel(frame_, image_, x, y, color, hit_class);
    PixelRecord& pixel = record(x, y);
    pixel.r = color.r;
    pixel.g = color.g;
    pixel.b = color.b;
    pixel.hit_class = hit_class;
    if (pixel.written < 255) ++pixel.written;
  }

  void trace(std::uint32_t x, std::uint32_t y, std::uint32_t pass) {
    tap_.pixel(x, y, pass);
    const TracedPixel traced = tracer_.trace(x, y);
    PixelRecord& pixel = record(x, y);
    pixel.primitive = traced.primitive;
    pixel.t_bits = traced.t_bits;
    store(x, y, traced.color, traced.hit_class);
  }

  void decide(const Pass& pass, std::uint32_t number, std::uint32_t x, std::uint32_t y) {
    Candidate candidate = candidate_at(frame_, image_, pass, number, x, y);
    candidate.counts = count_hits(candidate.ring);
    candidate.threshold = policy_.threshold(candidate, config_.selective);
    ++counts_.candidates;
    counts_.static_neighbours += candidate.counts.n_static;
    counts_.dynamic_neighbours += candidate.counts.n_dynamic;
    counts_.lowered += candidate.threshold < config_.selective.reference;
    counts_.raised += candidate.threshold > config_.selective.reference;
    counts_.differences += pass.kind == PassKind::centre ? 2 : 1;
    const int difference = color_difference(config_.selective.metric, candidate.pairs);
    if (is_interpolated(candidate.pairs, difference, candidate.threshold)) {
      ++counts_.interpolated;
      note_decision(candidate, difference, Decision::interpolated, record(x, y));
      tap_.interpolated(x, y, number);
      store(x, y, interpolate(candidate.pairs), HitClass::none);
    } else {
      ++counts_.traced;
      note_decision(candidate, difference, Decision::traced, record(x, y));
      trace(x, y, number);
    }
  }

  const UnitConfig& config_;
  const PassPlan plan_;
  const Policy& policy_;
  const FrameDescriptor& frame_;
  MemoryImage& image_;
  PixelRecords& records_;
  Tap& tap_;
  FunctionalCounts counts_;
  PixelTracer<Tap> tracer_;
};

template <class Tap>
FunctionalCounts FunctionalUnit::run(Address descriptor, std::uint32_t stack_needed, PixelRecords& records,
                                     Tap& tap) const {
  FrameRegisters registers;
  registers.skip = config_.skip;
  take_descriptor(image_.at<FrameDescriptor>(descriptor), config_.shading, registers);
  take_lights(image_, registers);
  const bool overflows = stack_needed > config_.core.stack_entries;
  return FrameRendering<Tap>(config_, registers, image_, portable_, overflows, records, tap).run();
}

}  // namespace artu::hw
