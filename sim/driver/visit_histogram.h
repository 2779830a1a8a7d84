// How many nodes rays visit, by kind of ray.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hw/datapath/pixel_rays.h"
#include "hw/memory/image.h"
#include "hw/unit_config.h"

namespace artu::sim {

/// By RayKind: [n] is how many rays visited n inner nodes.  Empty where nobody counted.
using VisitHistogram = std::array<std::vector<std::uint64_t>, hw::ray_kinds>;

/// Renders the frame once more without time, which the event model need not know of: counting each ray's visits in its
/// traversal would cost every run.  The rays and their visits are the same, but with tree_builder.overlap, where the
/// time decides which tree a ray visits first (docs/fidelity.md).
VisitHistogram count_visits(const hw::UnitConfig& unit, hw::MemoryImage& image, hw::Address descriptor,
                            std::uint32_t stack_needed, std::size_t pixels);

}  // namespace artu::sim
