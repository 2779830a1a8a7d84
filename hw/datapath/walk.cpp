#include "hw/datapath/walk.h"

#include <vector>

namespace artu::hw {

namespace {

void test_leaf(const HitTests& tests, const FrameDescriptor& frame, const MemoryImage& image, const Ray& ray,
               std::uint32_t leaf, bool any, Found& found, WalkCounts& counts) {
  const bool dynamic = NodeReference::is_dynamic(leaf);
  const Address base = dynamic ? frame.dynamic_triangles : frame.static_triangles;
  for (std::uint32_t i = 0; i < NodeReference::count(leaf) && !(any && found.hit); ++i) {
    const std::uint32_t triangle = NodeReference::first(leaf) + i;
    const auto& record = image.at<TriangleRecord>(base + Address{triangle} * sizeof(TriangleRecord));
    TriangleHit hit;
    ++counts.triangles;
    if (tests.triangle(ray, record.a, record.b, record.c, hit))
      consider(hit, record.primitive, triangle, dynamic, found);
  }
}

}  // namespace

Found walk(const HitTests& tests, const FrameDescriptor& frame, const MemoryImage& image, const Ray& ray, bool any,
           WalkCounts* counts) {
  WalkCounts own;
  WalkCounts& count = counts != nullptr ? *counts : own;
  Found found;
  if (is_zero(ray.direction)) return found;
  thread_local std::vector<Step> stack;
  stack.clear();
  Steps steps;
  tests.roots(frame, ray, 0, steps);
  for (;;) {
    count.boxes += steps.tests;
    for (std::uint32_t i = steps.count; i-- > 0;) stack.push_back(steps.step[i]);
    steps.count = steps.tests = 0;
    if (stack.empty() || (any && found.hit)) return found;
    const Step step = stack.back();
    stack.pop_back();
    if (found.hit && step.enter > found.best.t) continue;
    if (NodeReference::is_leaf(step.node)) {
      test_leaf(tests, frame, image, ray, step.node, any, found, count);
      continue;
    }
    const bool dynamic = NodeReference::is_dynamic(step.node);
    const TreeKind kind = dynamic ? frame.dynamic_kind : frame.static_kind;
    const Address nodes = dynamic ? frame.dynamic_nodes : frame.static_nodes;
    const Address record = nodes + Address{NodeReference::index(step.node)} * node_bytes(kind);
    ++count.nodes;
    tests.node(kind, &image.at<std::uint8_t>(record), ray, step, found.hit ? found.best.t : ray.tmax, 0, steps);
  }
}

}  // namespace artu::hw
