// What a traversal finds in a tree of any kind is what testing every triangle finds, to the bit.
#include <gtest/gtest.h>

#include <memory>

#include "tree_check.h"
#include "tree_rays.h"

namespace artu::sim::test {

namespace {

constexpr int ray_count = 20000;

const hw::HitTests& tests() {
  static const hw::HitTests binary32;
  return binary32;
}

hw::Found brute_force(const traces::Mesh& mesh, std::uint32_t first_id, bool dynamic, const hw::Ray& ray,
                      hw::Found found = {}) {
  for (std::uint32_t i = 0; i < mesh.triangle_count(); ++i) {
    hw::TriangleHit hit;
    if (tests().triangle(ray, vertex(mesh, i, 0), vertex(mesh, i, 1), vertex(mesh, i, 2), hit)) {
      consider(hit, first_id + i, i, dynamic, found);
    }
  }
  return found;
}

bool same(const hw::Found& a, const hw::Found& b) {
  if (a.hit != b.hit) return false;
  if (!a.hit) return true;
  return a.primitive == b.primitive && a.dynamic == b.dynamic && hw::bits_of(a.best.t) == hw::bits_of(b.best.t) &&
         hw::bits_of(a.best.U) == hw::bits_of(b.best.U) && hw::bits_of(a.best.V) == hw::bits_of(b.best.V) &&
         hw::bits_of(a.best.det) == hw::bits_of(b.best.det);
}

std::string text(const hw::Ray& ray, const hw::Found& want, const hw::Found& got) {
  char line[400];
  std::snprintf(line, sizeof line, "origin %a %a %a direction %a %a %a tmax %a: want %d %u %a, got %d %u %a",
                ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.tmax,
                want.hit, want.primitive, want.best.t, got.hit, got.primitive, got.best.t);
  return line;
}

struct Memory {
  hw::MemoryImage image;
  hw::FrameDescriptor frame{};
  Memory() { frame.static_root = frame.dynamic_root = hw::NodeReference::none; }
};

void expect_walks_agree(const traces::Mesh& mesh, std::uint32_t seed) {
  std::vector<float> planes[3];
  std::vector<std::unique_ptr<Memory>> memories;
  hw::Vector lo, hi;
  for (const hw::TreeKind kind : kinds) {
    const Tree tree = build_tree(mesh, kind, false, "test");
    TreeCheck check(mesh, tree, false);
    check.run();
    for (int axis = 0; axis < 3; ++axis) {
      planes[axis].insert(planes[axis].end(), check.planes[axis].begin(), check.planes[axis].end());
    }
    memories.push_back(std::make_unique<Memory>());
    place(mesh, tree, false, 0, memories.back()->image, memories.back()->frame);
    lo = tree.lo;
    hi = tree.hi;
  }
  RaySource rays(mesh, planes, lo, hi, seed);
  int hits = 0, wrong = 0;
  for (int i = 0; i < ray_count && wrong < 5; ++i) {
    const hw::Ray ray = rays.next();
    const hw::Found want = brute_force(mesh, 0, false, ray);
    hits += want.hit ? 1 : 0;
    for (std::size_t kind = 0; kind < memories.size(); ++kind) {
      const Memory& memory = *memories[kind];
      const hw::Found got = walk(tests(), memory.frame, memory.image, ray, false);
      const hw::Found any = walk(tests(), memory.frame, memory.image, ray, true);
      if (same(want, got) && any.hit == want.hit) continue;
      ++wrong;
      ADD_FAILURE() << name(kinds[kind]) << (same(want, got) ? " any: " : ": ")
                    << text(ray, want, same(want, got) ? any : got);
    }
  }
  EXPECT_GT(hits, ray_count / 20);
}

struct Model {
  const char* name;
  traces::Mesh (*mesh)();
};

const Model models[] = {
    {"soup", [] { return soup(500, 0.3f); }},          {"slivers", [] { return slivers(500); }},
    {"sphere", [] { return sphere(20, 12); }},         {"heights", [] { return heights(15); }},
    {"coincident", [] { return coincident(24, 20); }},
};

struct Change {
  const char* name;
  float scale, move;
};

const Change changes[] = {{"as_is", 1, 0},           {"moved_1000", 1, 1000}, {"moved_1e5", 1, 1e5f},
                          {"scaled_1e_6", 1e-6f, 0}, {"scaled_1e6", 1e6f, 0}, {"huge", 0x1p60f, 0},
                          {"tiny", 0x1p-60f, 0}};

class TreeWalk : public testing::TestWithParam<std::tuple<Model, Change>> {};

TEST_P(TreeWalk, AgreesWithBruteForce) {
  const auto& [model, change] = GetParam();
  expect_walks_agree(transformed(model.mesh(), change.scale, change.move), 11);
}

INSTANTIATE_TEST_SUITE_P(All, TreeWalk, testing::Combine(testing::ValuesIn(models), testing::ValuesIn(changes)),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param).name;
                         });

TEST(TreeWalkOdd, AFewTriangles) {
  for (int count : {1, 2, 3, 5, 17}) expect_walks_agree(soup(count, 0.5f), 12);
}

TEST(TreeWalkOdd, AllSizesTogether) { expect_walks_agree(all_sizes(500), 13); }

/// Both classes at once, each with every kind of tree.
TEST(TreeWalkOdd, StaticAndDynamicTreesOfAnyKinds) {
  const traces::Mesh still = sphere(16, 10), moving = heights(10);
  const auto still_count = static_cast<std::uint32_t>(still.triangle_count());
  const std::vector<float> no_planes[3];
  RaySource rays(moving, no_planes, {-1, -1, -1}, {1, 1, 1}, 14);
  for (const hw::TreeKind a : kinds) {
    for (const hw::TreeKind b : kinds) {
      Memory memory;
      place(still, build_tree(still, a, false, "test"), false, 0, memory.image, memory.frame);
      place(moving, build_tree(moving, b, true, "test"), true, still_count, memory.image, memory.frame);
      for (int i = 0; i < 2000; ++i) {
        const hw::Ray ray = rays.next();
        const hw::Found want = brute_force(moving, still_count, true, ray, brute_force(still, 0, false, ray));
        const hw::Found got = walk(tests(), memory.frame, memory.image, ray, false);
        ASSERT_TRUE(same(want, got)) << name(a) << " " << name(b) << ": " << text(ray, want, got);
        ASSERT_EQ(walk(tests(), memory.frame, memory.image, ray, true).hit, want.hit);
      }
    }
  }
}

}  // namespace

}  // namespace artu::sim::test
