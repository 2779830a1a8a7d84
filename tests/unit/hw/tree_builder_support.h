// A tree builder between a scripted control unit and a scripted memory, and frames for it.
#pragma once

#include <cmath>

#include "hw/memory/tree_builder.h"
#include "unit/hw/support.h"

namespace artu::hw::test {

inline constexpr Address input_at = 1 << 20, scratch_at = 2 << 20, nodes_at = 3 << 20, triangles_at = 4 << 20,
                         attributes_at = 5 << 20;

/// A frame whose binary tree halves `n` triangles down to single ones.
inline FrameDescriptor halved(std::uint32_t n, std::uint32_t on_chip) {
  FrameDescriptor frame{};
  frame.dynamic_triangle_count = frame.dynamic_reference_count = n;
  frame.dynamic_node_lines = n - 1;
  frame.build_input = input_at;
  frame.build_scratch = scratch_at;
  frame.dynamic_nodes = nodes_at;
  frame.dynamic_triangles = triangles_at;
  frame.dynamic_attributes = attributes_at;
  BuildWork& work = frame.build;
  work.lower_references = n;
  std::vector<std::uint32_t> level{n};
  for (std::uint32_t depth = 1; !level.empty(); ++depth) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t count : level) {
      if (count == 1) continue;
      ++work.splits;
      work.references += count;
      if (count > on_chip) {
        ++work.upper_splits;
        work.upper_references += count;
        work.upper_levels = depth;
      }
      next.push_back(count / 2);
      next.push_back(count - count / 2);
    }
    level = next;
  }
  return frame;
}

struct BuilderBench {
  static constexpr Cycle memory_latency = 1;
  BuilderBench(const TreeBuilderConfig& config, const FrameDescriptor& frame, Cycle latency = memory_latency,
               bool asked = true)
      : builder(bench.block<TreeBuilder>("builder", config, registers)),
        memory(bench.block<ScriptedMemory>("memory", link, 1, latency)),
        command(bench.block<Source<BuildToken>>("command", build)),
        answer(bench.block<Sink<BuildToken>>("answer", built)) {
    registers.descriptor = frame;
    link.bind(builder, memory);
    build.bind(command, builder);
    built.bind(builder, answer);
    builder.bind(link, build, built);
    if (asked) command.push_at(1, {});
  }
  std::uint64_t lines(const char* name) const { return counter(builder, name); }

  Bench bench;
  FrameRegisters registers;
  MemoryLink& link = bench.link("link", 8, 1, 1);
  Fifo<BuildToken>& build = bench.fifo<BuildToken>("build", 2);
  Fifo<BuildToken>& built = bench.fifo<BuildToken>("built", 2);
  TreeBuilder& builder;
  ScriptedMemory& memory;
  Source<BuildToken>& command;
  Sink<BuildToken>& answer;
};

/// What a step takes if the memory answers at once: `lines` are issued one a cycle, from the one on in which the step
/// begins; the last one arrives in the cycle after its issue, and its answer is there memory_latency later.
inline Cycle step_cycles(Cycle compute, Cycle lines) {
  return std::max(compute, lines == 0 ? 0 : lines + BuilderBench::memory_latency);
}

inline std::uint64_t lines_of(std::uint64_t bytes) { return (bytes + 63) / 64; }

}  // namespace artu::hw::test
