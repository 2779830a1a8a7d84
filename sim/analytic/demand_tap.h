// Listens to a functional rendering: which lines are asked for, and when about.
#pragma once

#include "hw/functional/counts.h"
#include "hw/memory/layout.h"
#include "hw/ray_core/pipelines.h"
#include "hw/selective/pass_plan.h"
#include "sim/analytic/interleaving.h"

namespace artu::sim {

/// Requests of the L1 caches' clients, counted one by one: those that are not sampled, too.
struct RequestCounts {
  std::uint64_t second_node_lines = 0, triangles = 0, texture_lines = 0, pixel_lines = 0, written_lines = 0;
};

class DemandTap {
 public:
  DemandTap(const hw::UnitConfig& config, const hw::FrameDescriptor& frame, MemoryModel& memory);

  void pixel(std::uint32_t x, std::uint32_t y, std::uint32_t pass) {
    enter(x, y, pass);
    order_.begin_pixel(x, y);
  }
  void interpolated(std::uint32_t x, std::uint32_t y, std::uint32_t pass) {
    enter(x, y, pass);
    order_.pass_candidate();
  }
  void ray(hw::RayKind kind) { order_.advance(kind == hw::RayKind::primary ? primary_cycles_ : ray_cycles_); }
  void node(hw::Address record, hw::TreeKind kind) {
    order_.advance(node_cycles_[static_cast<std::size_t>(kind)]);
    ask(Client::node, record);
    if (kind == hw::TreeKind::bvh8) {
      ++counts_.second_node_lines;
      ask(Client::node, record + 64);
    }
  }
  void leaf(hw::Address first, std::uint32_t count) {
    order_.advance(leaf_cycles_ + count);
    counts_.triangles += count;
    for (std::uint32_t i = 0; i < count; ++i) ask(Client::triangle, first + i * sizeof(hw::TriangleRecord));
  }
  void hit_point(hw::Address triangle, hw::Address attributes) {
    order_.advance(hit_cycles_);
    counts_.triangles += 2;
    ask(Client::triangle, triangle);
    ask(Client::triangle, attributes);
  }
  void material(hw::Address record) {
    texels_ = 0;
    counts_.texture_lines += 2;
    ask(Client::texture, record);
    ask(Client::texture, record + 64);
  }
  void texel(hw::Address texel) {
    const hw::Address line = texel / 64;
    for (std::uint32_t i = 0; i < texels_; ++i) {
      if (texel_lines_[i] == line) return;
    }
    texel_lines_[texels_++] = line;
    ++counts_.texture_lines;
    ask(Client::texture, texel);
  }
  void end_of_pixel() { order_.end_pixel(); }

  /// After the frame.
  void finish();
  /// A pass begins; `counts` are of all before it.
  void begin_pass(std::uint32_t pass, const hw::FunctionalCounts& counts);
  const RequestCounts& counts() const { return counts_; }
  const Interleaving& order() const { return order_; }
  /// What `memory` had counted when the first pass was over.
  const MemoryCounts& first_memory() const { return first_memory_; }
  /// And the blocks and clients.
  const hw::FunctionalCounts& first_counts() const { return first_counts_; }
  const RequestCounts& first_requests() const { return first_requests_; }

 private:
  void ask(Client client, hw::Address record) {
    const std::uint64_t line = record / 64;
    if (is_sampled(line)) order_.read(client, line);
  }
  /// The row of a tile that the pixel lies in: the first pixel of it asks for what the others look at, too.
  void enter(std::uint32_t x, std::uint32_t y, std::uint32_t pass) {
    const std::uint32_t column = x / tile_;
    if (y == y_ && column == column_ && pass == pass_) return;
    open_span(column, y, pass);
  }
  void open_span(std::uint32_t column, std::uint32_t y, std::uint32_t pass);
  void read_row(std::uint32_t left, std::uint32_t right, std::uint32_t y);

  const hw::FrameDescriptor& frame_;
  const hw::PassPlan plan_;
  const std::uint32_t tile_;
  const bool overlaps_;
  MemoryModel& memory_;
  Interleaving order_;
  std::uint32_t primary_cycles_, ray_cycles_, leaf_cycles_, hit_cycles_;
  std::array<std::uint32_t, 4> node_cycles_{};
  RequestCounts counts_;
  MemoryCounts first_memory_;
  hw::FunctionalCounts first_counts_;
  RequestCounts first_requests_;
  std::uint32_t y_ = ~0u, column_ = 0, pass_ = 0;
  std::uint32_t texels_ = 0;
  std::array<hw::Address, 4> texel_lines_{};
};

}  // namespace artu::sim
