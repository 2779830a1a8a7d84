// Scene and frame to FlatBuffers, one a chunk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "traces/frame.h"

namespace artu::traces {

/// Receives finished chunks in the order of the file; the bytes live until it returns.
using ChunkSink = std::function<void(const std::uint8_t* data, std::size_t size)>;

void pack(const Scene& scene, const ChunkSink& sink);
void pack(const Frame& frame, const ChunkSink& sink);

}  // namespace artu::traces
