// The subjects of the campaign: brute force, the unit's walk on every kind of tree, and the golden model.
#pragma once

#include <vector>

#include "hw/memory/image.h"
#include "ref/tracer.h"
#include "sim/stress/geometry.h"
#include "sim/stress/subject.h"

namespace artu::sim {

/// A case as it lies in the unit's memory, as far as traversal reads it.
struct LaidDown {
  hw::MemoryImage image;
  hw::FrameDescriptor frame{};
};
std::shared_ptr<const LaidDown> lay_down(const StressGeometry& geometry, hw::TreeKind kind);

/// hw::intersect and hw::consider on every triangle.  `triangles` must outlive it.
SubjectPointer brute_force(const std::vector<Corners>& triangles);
SubjectPointer walker(std::string name, std::shared_ptr<const LaidDown> laid);
SubjectPointer golden_traversal(std::shared_ptr<const ref::Tracer> tracer);
/// The farther the origins, the wider Embree's boxes: `near` answers rays from within `origins`, `far` all others.
SubjectPointer golden_traversal(std::shared_ptr<const ref::Tracer> near, const ref::Extent& origins,
                                std::shared_ptr<const ref::Tracer> far);
SubjectPointer golden_brute_force(std::shared_ptr<const ref::Tracer> tracer);

const char* kind_name(hw::TreeKind kind);

}  // namespace artu::sim
