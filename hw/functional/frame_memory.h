// Where a frame's trees and triangles lie: the descriptor's addresses as pointers.
#pragma once

#include "hw/memory/image.h"

namespace artu::hw {

struct FrameMemory {
  FrameMemory(const FrameDescriptor& frame, const MemoryImage& image)
      : frame(frame),
        base(&image.at<std::uint8_t>(0)),
        nodes{base + frame.static_nodes, base + frame.dynamic_nodes},
        triangles{base + frame.static_triangles, base + frame.dynamic_triangles},
        kind{frame.static_kind, frame.dynamic_kind},
        node_size{node_bytes(frame.static_kind), node_bytes(frame.dynamic_kind)} {}

  const std::uint8_t* node(std::uint32_t reference) const {
    const std::size_t dynamic = NodeReference::is_dynamic(reference);
    return nodes[dynamic] + std::size_t{NodeReference::index(reference)} * node_size[dynamic];
  }
  const TriangleRecord* leaf(std::uint32_t reference) const {
    const std::size_t dynamic = NodeReference::is_dynamic(reference);
    return reinterpret_cast<const TriangleRecord*>(triangles[dynamic]) + NodeReference::first(reference);
  }
  Address address_of(const void* record) const {
    return static_cast<Address>(static_cast<const std::uint8_t*>(record) - base);
  }

  const FrameDescriptor& frame;
  const std::uint8_t* const base;
  // Static, dynamic.
  const std::uint8_t* const nodes[2];
  const std::uint8_t* const triangles[2];
  const TreeKind kind[2];
  const std::size_t node_size[2];
};

}  // namespace artu::hw
