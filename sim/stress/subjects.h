// The subjects of the campaign: brute force, the unit's walk on every kind of tree, and the golden model.
#pragma once

#include <vector>

#include "hw/datapath/hit_tests.h"
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

/// The unit's triangle test on every triangle.  `triangles` must outlive it.
SubjectPointer brute_force(const std::vector<Corners>& triangles, const hw::HitTests& tests = hw::HitTests());
SubjectPointer walker(std::string name, std::shared_ptr<const LaidDown> laid,
                      const hw::HitTests& tests = hw::HitTests());
SubjectPointer golden_traversal(const std::shared_ptr<const ref::Tracer>& tracer);
/// The farther the origins and the narrower the format, the wider Embree's boxes, up to testing every triangle: `near`
/// answers rays from within `origins`, `far` all others.
SubjectPointer golden_traversal(std::shared_ptr<const ref::Tracer> near, const ref::Extent& origins,
                                std::shared_ptr<const ref::Tracer> far, bool far_is_slow = false);
SubjectPointer golden_brute_force(std::shared_ptr<const ref::Tracer> tracer);

}  // namespace artu::sim
