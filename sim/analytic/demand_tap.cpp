#include "sim/analytic/demand_tap.h"

namespace artu::sim {

DemandTap::DemandTap(const hw::UnitConfig& config, const hw::FrameDescriptor& frame, MemoryModel& memory)
    : frame_(frame),
      plan_(config.selective),
      tile_(config.selective.tile),
      overlaps_(config.selective.overlaps()),
      memory_(memory),
      order_(config, frame.width, memory) {
  const hw::Pipelines p(config.operators);
  const hw::RayCoreConfig& core = config.core;
  primary_cycles_ = p.generate + p.set_up + p.box;
  ray_cycles_ = p.set_up + p.box;
  for (std::size_t kind = 0; kind < node_cycles_.size(); ++kind) {
    node_cycles_[kind] = core.node_cache.hit_latency + p.node(static_cast<hw::TreeKind>(kind)) + 3;
  }
  leaf_cycles_ = core.triangle_cache.hit_latency + p.triangle + 3;
  hit_cycles_ = core.triangle_cache.hit_latency + p.hit_point + core.texture_cache.hit_latency + p.texture +
                p.accumulate + p.light + 6;
}

void DemandTap::finish() { order_.drain(); }

void DemandTap::read_row(std::uint32_t left, std::uint32_t right, std::uint32_t y) {
  const std::uint64_t row = std::uint64_t{y} * frame_.pitch;
  const auto read = [this](hw::Address first, hw::Address last) {
    for (std::uint64_t line = first / 64; line <= last / 64; ++line) {
      ++counts_.pixel_lines;
      if (is_sampled(line)) order_.read_pixels(line);
    }
  };
  read(frame_.frame_buffer + (row + left) * 4, frame_.frame_buffer + (row + right) * 4);
  read(frame_.hit_classes + row + left, frame_.hit_classes + row + right);
}

void DemandTap::begin_pass(std::uint32_t pass, const hw::FunctionalCounts& counts) {
  if (!overlaps_ || pass == 1) order_.drain();
  if (pass != 1) return;
  first_memory_ = memory_.counts();
  first_counts_ = counts;
  first_requests_ = counts_;
}

void DemandTap::open_span(std::uint32_t column, std::uint32_t y, std::uint32_t pass) {
  y_ = y;
  column_ = column;
  pass_ = pass;
  const std::uint32_t begin = column * tile_, end = std::min(begin + tile_, frame_.width);
  if (pass != 0) {
    const hw::Pass p = plan_.pass(pass);
    const std::uint32_t left = begin + p.x0 - std::min(begin + p.x0, p.h),
                        right = std::min(end - 1 + p.h, frame_.width - 1);
    if (p.compares_columns()) read_row(left, right, y - p.h);
    if (p.compares_rows()) read_row(left, right, y);
    if (p.compares_columns() && y + p.h < frame_.height) read_row(left, right, y + p.h);
  }
  const std::uint64_t index = std::uint64_t{y} * frame_.pitch + begin;
  const auto write = [this](Client writer, hw::Address address) {
    ++counts_.written_lines;
    if (is_sampled(address / 64)) order_.write_pixels(writer, address / 64);
  };
  // A line of 16 pixels that are all of one pass is written whole, and not fetched.
  const bool whole = plan_.pass(pass).dx == 1 && begin + 16 <= end;
  write(whole ? Client::line_writer : Client::writer, frame_.frame_buffer + index * 4);
  write(Client::writer, frame_.hit_classes + index);
}

}  // namespace artu::sim
