// hw/datapath/operations.h against the datapaths: their own source, compiled with a binary32 that counts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include "unit/hw/counting_number.h"

// From here on the datapaths are in a namespace of their own, and `float` is a class.
#define ARTU_PORTABLE  // vectors of the machine cannot count
#define float counting::Number<0>
#define artu counted
#include "hw/datapath/box.cpp"
#include "hw/datapath/hit_point.cpp"
#include "hw/datapath/hit_tests.cpp"
#include "hw/datapath/node_visit.cpp"
#include "hw/datapath/operations.h"
#include "hw/datapath/ray.cpp"
#include "hw/datapath/texture.cpp"
#define of_width shading_of_width  // both files have one
#include "hw/datapath/shading.cpp"
#undef of_width
#undef artu
#undef float

namespace counted::hw {

/// A table look-up, without operators.
counting::Number<0> decode(std::uint32_t code) { return {static_cast<counting::Binary32>(code) / 255}; }

namespace {

using Binary32 = counting::Number<0>;
using Format = counting::Number<1>;     // of the datapath
using BoxFormat = counting::Number<2>;  // of the box test within the triangle test

Operations operations_of(const counting::Tally& t) { return {t.add, t.multiply, t.divide, t.square_root, t.compare}; }

std::string text(Operations o) {
  return std::to_string(o.add) + " add, " + std::to_string(o.multiply) + " multiply, " + std::to_string(o.divide) +
         " divide, " + std::to_string(o.square_root) + " square root, " + std::to_string(o.compare) + " compare";
}

template <class Datapath>
DatapathOperations count(const Datapath& datapath) {
  Binary32::tally = {};
  Format::tally = {};
  BoxFormat::tally = {};
  datapath();
  return {operations_of(Format::tally), operations_of(Binary32::tally)};
}

void expect_equal(DatapathOperations counted, DatapathOperations stated) {
  EXPECT_EQ(text(counted.narrow), text(stated.narrow)) << "in the datapath's format";
  EXPECT_EQ(text(counted.binary32), text(stated.binary32)) << "in binary32";
}

Vector vector(counting::Binary32 x, counting::Binary32 y, counting::Binary32 z) { return {x, y, z}; }

/// Along z, a little askew, so that it is parallel to no axis.
Ray askew() {
  Ray ray;
  ray.origin = vector(0, 0, -5);
  ray.direction = unit(vector(0.1f, 0.2f, 1));
  set_up(ray);
  return ray;
}

TEST(Operations, ABoxIsCounted) {
  const Ray ray = askew();
  Interval interval{};
  expect_equal(count([&] { interval = box_interval<Format>(ray, vector(-2, -2, -2), vector(2, 2, 2), 1); }),
               operations::box_interval);
  bool met = false;
  expect_equal(count([&] { met = meets(interval, 100); }), operations::box_meets);
  EXPECT_TRUE(met);
}

template <class Record>
DatapathOperations visit(TreeKind kind, const Record& node, std::uint32_t children) {
  const Ray ray = askew();
  const Step from{0, 0, 100};
  Steps steps;
  const DatapathOperations counted = count([&] { visit_node<Format>(kind, &node, ray, from, 100, 1, 0, steps); });
  EXPECT_EQ(steps.count, children) << "every child is met";
  return counted;
}

/// Children whose order is the worst for the sorting: each is nearer than all before it.
template <int Width>
WideNodeRecord<Width> backward() {
  WideNodeRecord<Width> node{};
  node.origin = vector(-10, -10, 0);
  for (auto& exponent : node.exponent) exponent = 127;
  node.count = Width;
  for (int i = 0; i < Width; ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      node.lo[axis][i] = 0;
      node.hi[axis][i] = 30;
    }
    node.lo[2][i] = static_cast<std::uint8_t>(2 * (Width - i));
    node.hi[2][i] = static_cast<std::uint8_t>(2 * (Width - i) + 1);
  }
  return node;
}

/// n boxes and the comparisons of the worst order; what the header charges a box covers them.
void expect_boxes(DatapathOperations counted, TreeKind kind, std::uint32_t n, DatapathOperations box) {
  DatapathOperations all;
  for (std::uint32_t i = 0; i < n; ++i) all = all + box;
  all.binary32.compare += n * (n - 1) / 2;
  expect_equal(counted, all);
  EXPECT_GE(n * operations::box_test(kind).binary32.compare, all.binary32.compare) << "sorting is charged by the box";
  Operations charged = n * operations::box_test(kind).binary32;
  charged.compare = all.binary32.compare;
  EXPECT_EQ(text(charged), text(all.binary32));
  EXPECT_EQ(text(n * operations::box_test(kind).narrow), text(all.narrow));
}

TEST(Operations, ANodeOfEveryKindIsCounted) {
  NodeRecord binary{};
  for (int i = 0; i < 2; ++i) {
    binary.lo[i] = vector(-3, -3, i == 0 ? 2 : 0);
    binary.hi[i] = vector(3, 3, i == 0 ? 3 : 1);
  }
  const DatapathOperations box = operations::box_interval + operations::box_meets;
  expect_boxes(visit(TreeKind::bvh2, binary, 2), TreeKind::bvh2, 2, box);
  expect_boxes(visit(TreeKind::bvh4, backward<4>(), 4), TreeKind::bvh4, 4, operations::box_decode + box);
  expect_boxes(visit(TreeKind::bvh8, backward<8>(), 8), TreeKind::bvh8, 8, operations::box_decode + box);
  KdNodeRecord plane{};
  plane.axis = 2;
  expect_equal(visit(TreeKind::kd, plane, 2), operations::box_test(TreeKind::kd));
}

TEST(Operations, ATriangleIsCounted) {
  const Ray ray = askew();
  TriangleHit hit;
  DatapathOperations counted = count([&] {
    const auto box = [](const Ray& r, Vector lo, Vector hi) { return box_interval<BoxFormat>(r, lo, hi, 1); };
    ASSERT_TRUE(intersect<Format>(ray, vector(-3, -3, 0), vector(4, -3, 0), vector(0, 4, 0), box, hit));
  });
  // The box test that clamps t is charged as one.
  EXPECT_EQ(text(operations_of(BoxFormat::tally)), text(operations::box_interval.narrow));
  const Operations box = operations::box_interval.binary32;
  counted.binary32.add -= box.add;
  counted.binary32.compare -= box.compare;
  // Three differences of exact products, which the datapath computes in binary64.
  EXPECT_EQ(Format::tally.to_double, 12u);
  counted.narrow.multiply += 6;
  counted.narrow.add += 3;
  // The comparison with the best hit so far: on the same t it looks twice.
  const DatapathOperations best = count([&] { EXPECT_TRUE(nearer(hit, 1, hit, 2)); });
  expect_equal(counted + best, operations::triangle_test);
}

TEST(Operations, RaysAreCounted) {
  CameraRegisters camera{};
  camera.corner = vector(-1, -1, 1);
  camera.du = vector(0.1f, 0, 0);
  camera.dv = vector(0, 0.1f, 0);
  Ray ray;
  expect_equal(count([&] { ray = primary_ray(camera, 3, 4); }), {{}, operations::primary_ray});
  DatapathOperations counted = count([&] { set_up(ray); });
  // The model computes the three inverses a second time, to see which are limited.
  counted.binary32.divide -= 3;
  counted.binary32.compare -= 3;
  expect_equal(counted, {{}, operations::ray_set_up});
}

TEST(Operations, AHitPointIsCounted) {
  TriangleRecord triangle{};
  triangle.a = vector(-3, -3, 0);
  triangle.b = vector(0, 4, 0);
  triangle.c = vector(4, -3, 0);
  AttributeRecord attributes{};
  for (Vector& normal : attributes.normal) normal = vector(0, 0, -1);
  TriangleHit hit;
  hit.U = hit.V = 1;
  hit.det = 3;
  DatapathOperations counted = count([&] { surface_at(askew(), hit, triangle, attributes); });
  const DatapathOperations ray = count([] { askew(); });
  const auto without = [](Operations a, Operations b) -> Operations {
    return {a.add - b.add, a.multiply - b.multiply, a.divide - b.divide, a.square_root - b.square_root,
            a.compare - b.compare};
  };
  counted.binary32 = without(counted.binary32, ray.binary32);
  counted.binary32.divide -= 9;  // codes over 255 are a table
  expect_equal(counted, {{}, operations::hit_point});
}

TEST(Operations, ATextureIsCounted) {
  MaterialRecord material{};
  material.width = material.height = 8;
  material.wrap_u = material.wrap_v = TextureWrap::mirror;  // the longest
  TextureFootprint at;
  expect_equal(count([&] { at = footprint(material, 1.3f, 1.4f); }), operations::texture_address);
  expect_equal(count([&] { filter<Format>(at, {1, 2, 3, 4}); }), operations::texture_filter);
}

ShadedPoint glass() {
  ShadedPoint point;
  point.direction = unit(vector(0.1f, 0.2f, 1));
  point.geometric_normal = point.shading_normal = vector(0, 0, -1);
  point.weight = point.diffuse = point.specular = point.mirror = point.transmission = vector(1, 1, 1);
  // The last component decides, so that every one is looked at.
  point.specular = point.transmission = vector(0, 0, 1);
  point.ior = 1.5f;
  point.specular_log2 = 10;
  return point;
}

TEST(Operations, ShadingIsCounted) {
  ShadingConstants constants{};
  expect_equal(count([&] { sky<Format>(constants, vector(0, 1, 0)); }), operations::sky);
  expect_equal(count([] { add<Format>(vector(1, 1, 1), vector(1, 1, 1)); }), operations::add);
  expect_equal(count([] { add_weighted<Format>(vector(1, 1, 1), vector(1, 1, 1), vector(1, 1, 1)); }),
               operations::add_weighted);
  MaterialRecord material{};
  material.tint = 1;
  ShadedPoint point;
  expect_equal(count([&] {
                 begin_shading<Format>(constants, Surface(), material, vector(1, 1, 1), vector(0, 0, 1),
                                       vector(1, 1, 1), point);
               }),
               operations::begin_shading);
}

TEST(Operations, ALightIsCounted) {
  ShadedPoint point = glass();
  point.weight = vector(0, 0, 1);
  LightRecord light{};
  light.type = LightType::spot;
  light.position = vector(0, 0, -5);
  light.direction = vector(0, 0, 1);
  light.color = vector(1, 1, 1);
  light.range = 100;
  light.cos_inner = 0.9f;
  light.cos_outer = 0.5f;
  ShadowRay shadow;
  expect_equal(count([&] { EXPECT_TRUE(light_contribution<Format>(point, light, shadow)); }), operations::light);
}

TEST(Operations, NextRaysAreCounted) {
  ShadingConstants constants{};
  const ShadedPoint point = glass();
  NextRays next;
  expect_equal(count([&] { next = next_rays<Format>(constants, point); }), operations::next_rays);
  EXPECT_TRUE(next.reflection);
  EXPECT_TRUE(next.refraction);
}

}  // namespace
}  // namespace counted::hw
