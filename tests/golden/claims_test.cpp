// The method claims of KR 10-2537319 B1, a test each, on the simulated unit: the pixels are the golden model's to the
// bit, and do what the claim asks.  The comments quote the claims in English.
#include "golden/candidates.h"

namespace artu::golden_tests {
namespace {

const TestScene& scene() {
  static const TestScene scene = make_scene(attention_recipe());
  return scene;
}

sim::FrameOutcome exact(const hw::UnitConfig& config = {}, const TestScene& rendered = scene()) {
  Rendered r = run(rendered, config);
  expect_exact(r);
  return std::move(r.outcomes[0]);
}

hw::UnitConfig traced_everywhere() {
  hw::UnitConfig config;
  config.selective.enabled = false;
  return config;
}

/// Squared differences to the full render, of the pixels that see dynamic geometry.
std::uint64_t dynamic_error(const sim::FrameOutcome& outcome, const sim::FrameOutcome& full) {
  std::uint64_t error = 0;
  for (std::size_t i = 0; i < full.pixels.size(); ++i) {
    const hw::PixelRecord &a = outcome.pixels[i], &b = full.pixels[i];
    if (b.hit_class != hw::HitClass::dynamic_geometry) continue;
    for (int d : {a.r - b.r, a.g - b.g, a.b - b.b}) error += static_cast<std::uint64_t>(d * d);
  }
  return error;
}

// "A step of determining, for each sampling pixel, whether its primary ray hits, while a first image is rendered at a
// first resolution; and a step of repeatedly performing, while a second image of a higher resolution is rendered, for
// each of the candidate pixels between the sampling pixels, an adaptive threshold adjustment by the hit frequency of
// the surrounding pixels, and selective rendering by the adjusted threshold; whereby [...] whether selective rendering
// is performed adapts to the visual attention, so that rendering is faster while less image quality is lost."
TEST(Claim, C01_LowResolutionFirstThenEachCandidateByAnAdaptiveThreshold) {
  // Larger than the other scenes: the three phases must be worth more than what begins and ends them.
  const TestScene large = make_scene(attention_recipe(161, 121));
  const sim::FrameOutcome adaptive = exact({}, large), full = exact(traced_everywhere(), large);
  for (std::uint32_t y = 0; y < 121; ++y) {
    for (std::uint32_t x = 0; x < 161; ++x) {
      const hw::PixelRecord& p = record_at(adaptive, x, y);
      SCOPED_TRACE(at_text(x, y));
      const bool sampling = x % 2 == 0 && y % 2 == 0;
      EXPECT_EQ(p.pass == 0, sampling);
      EXPECT_EQ(p.decision == hw::Decision::sampled, sampling);
      EXPECT_EQ(p.threshold >= 0, !sampling) << "each candidate has a threshold of its own";
      if (!sampling) continue;
      EXPECT_NE(p.hit_class, hw::HitClass::none) << "whether its ray hits is not known";
      EXPECT_TRUE(same_color(p, record_at(full, x, y)));
    }
  }
  // Faster than tracing all, and better where attention is than with one threshold for all.
  EXPECT_LT(adaptive.rays_primary, full.rays_primary);
  EXPECT_LT(adaptive.cycles, full.cycles);
  hw::UnitConfig plain;
  plain.selective.adaptive = false;
  EXPECT_LT(dynamic_error(adaptive, full), dynamic_error(exact(plain, large), full));
}

// "[...] determining whether the primary ray hits a static scene or a dynamic scene that make up the scene."
TEST(Claim, C02_HitsAreStaticOrDynamic) {
  const sim::FrameOutcome outcome = exact();
  const auto first_dynamic = static_cast<std::int64_t>(scene().scene.static_geometry.triangle_count());
  std::array<int, 4> seen{};
  for (const hw::PixelRecord& p : outcome.pixels) {
    if (p.decision == hw::Decision::interpolated) continue;
    ++seen[static_cast<std::size_t>(p.hit_class)];
    EXPECT_EQ(p.hit_class, p.primitive < 0                ? hw::HitClass::miss
                           : p.primitive >= first_dynamic ? hw::HitClass::dynamic_geometry
                                                          : hw::HitClass::static_geometry);
  }
  EXPECT_EQ(seen[0], 0);
  for (std::size_t i : {1u, 2u, 3u}) EXPECT_GT(seen[i], 0) << "the scene does not show all classes";
}

// "[...] determining whether it hits as the result of intersection tests on the acceleration structure of the static
// scene or of the dynamic scene."  So geometry that moves from one structure to the other takes its class along, and
// nothing else of the hit changes.
TEST(Claim, C03_TheClassIsThatOfTheAccelerationStructure) {
  TestScene both = make_scene(attention_recipe()), still = both;
  traces::Mesh& to = still.scene.static_geometry;
  traces::Mesh& from = still.frames[0].dynamic;
  const auto offset = static_cast<std::uint32_t>(to.positions.size());
  const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  append(to.positions, from.positions);
  append(to.normals, from.normals);
  append(to.uvs, from.uvs);
  append(to.colors, from.colors);
  append(to.materials, from.materials);
  for (std::uint32_t index : from.indices) to.indices.push_back(index + offset);
  from = {};
  for (hw::TreeKind kind : {hw::TreeKind::bvh2, hw::TreeKind::kd}) {  // [0045]: either structure
    hw::UnitConfig config = traced_everywhere();
    config.accel.static_kind = config.accel.dynamic_kind = kind;
    const Rendered apart = run(both, config), merged = run(still, config);
    expect_exact(apart);
    expect_exact(merged);
    EXPECT_EQ(counter(apart.outcomes[0], "tree_builder", "builds"), 1u);
    EXPECT_EQ(merged.outcomes[0].dynamic_triangles, 0u);
    int moved = 0;
    for (std::size_t i = 0; i < apart.outcomes[0].pixels.size(); ++i) {
      const hw::PixelRecord &a = apart.outcomes[0].pixels[i], &b = merged.outcomes[0].pixels[i];
      EXPECT_EQ(a.t_bits, b.t_bits);
      EXPECT_EQ(a.primitive, b.primitive);
      EXPECT_TRUE(same_color(a, b));
      EXPECT_NE(b.hit_class, hw::HitClass::dynamic_geometry);
      if (a.hit_class == b.hit_class) continue;
      EXPECT_EQ(a.hit_class, hw::HitClass::dynamic_geometry);
      EXPECT_EQ(b.hit_class, hw::HitClass::static_geometry);
      ++moved;
    }
    EXPECT_GT(moved, 0);
  }
}

// "[...] counting, for each candidate pixel, the hits of the surrounding pixels, which is the hit frequency; and
// lowering the reference threshold if it exceeds a preset reference count, raising it if it is below that count."
TEST(Claim, C04_CollisionCountsMoveTheThreshold) {
  for (hw::Count count : {hw::Count::per_class, hw::Count::merged}) {  // [0069]
    std::array<int, 3> seen{};
    for (std::uint32_t reference_count = 0; reference_count <= 8; ++reference_count) {
      hw::UnitConfig config;
      config.selective.compare = hw::Compare::reference_count;
      config.selective.count = count;
      config.selective.reference_count = reference_count;
      config.selective.reference = 100;
      const sim::FrameOutcome outcome = exact(config);
      for (const SeenCandidate& c : candidates_of(outcome)) {
        SCOPED_TRACE(at_text(c.x, c.y));
        EXPECT_EQ(c.record.n_static, c.n_static);
        EXPECT_EQ(c.record.n_dynamic, c.n_dynamic);
        const int hits = c.n_dynamic + (count == hw::Count::merged ? c.n_static : 0);
        const int excess = hits - static_cast<int>(reference_count);
        EXPECT_EQ(c.record.threshold<100, excess> 0);
        EXPECT_EQ(c.record.threshold > 100, excess < 0);
        ++seen[excess > 0 ? 0 : excess < 0 ? 1 : 2];
      }
    }
    for (int of : seen) EXPECT_GT(of, 0) << "lowered, raised or left alone does not occur";
  }
}

// "[...] lowering the reference threshold if the first hit frequency, that of the dynamic scene, is higher than the
// second, that of the static scene, and raising it if it is lower."
TEST(Claim, C05_MoreDynamicThanStaticHitsLowerTheThreshold) {
  const sim::FrameOutcome outcome = exact();
  std::array<int, 3> seen{};
  for (const SeenCandidate& c : candidates_of(outcome)) {
    SCOPED_TRACE(at_text(c.x, c.y));
    EXPECT_EQ(c.record.threshold<16, c.n_dynamic> c.n_static);
    EXPECT_EQ(c.record.threshold > 16, c.n_dynamic < c.n_static);
    ++seen[c.record.threshold < 16 ? 0 : c.record.threshold > 16 ? 1 : 2];
  }
  for (int of : seen) EXPECT_GT(of, 0);
}

// "[...] determining how much the reference threshold is lowered or raised by the difference a) between the hit
// frequency and the reference count, or b) between the first and the second hit frequency."  [0071]: the greater the
// difference, the greater step by step, or in proportion.
TEST(Claim, C06_TheDifferenceSetsTheSizeOfTheMove) {
  const std::array<int, 9> progressive{0, 1, 2, 4, 7, 11, 16, 22, 29};
  // A reference count of 0 can only lower, one of 4 raises here.
  for (const auto& [compare, reference_count] : {std::pair{hw::Compare::reference_count, 0u},
                                                 {hw::Compare::reference_count, 4u},
                                                 {hw::Compare::dynamic_vs_static, 2u}}) {
    for (hw::Magnitude magnitude : {hw::Magnitude::proportional, hw::Magnitude::progressive}) {
      hw::UnitConfig config;
      config.selective.compare = compare;
      config.selective.reference_count = reference_count;
      config.selective.magnitude = magnitude;
      config.selective.reference = 100;
      config.selective.step = 5;
      const sim::FrameOutcome outcome = exact(config);
      std::array<int, 9> seen{};
      for (const SeenCandidate& c : candidates_of(outcome)) {
        SCOPED_TRACE(at_text(c.x, c.y));
        const int other = compare == hw::Compare::reference_count ? static_cast<int>(reference_count) : c.n_static;
        const auto difference = static_cast<std::size_t>(std::abs(c.n_dynamic - other));
        const int move =
            magnitude == hw::Magnitude::proportional ? 5 * static_cast<int>(difference) : progressive[difference];
        EXPECT_EQ(std::abs(c.record.threshold - 100), move);
        ++seen[difference];
      }
      EXPECT_GE(std::count_if(seen.begin(), seen.end(), [](int of) { return of > 0; }), 4) << "few differences occur";
    }
  }
}

// "[...] if the colour difference of the sampling pixels that are adjacent to a candidate pixel on both sides,
// vertically or horizontally, is smaller than the adjusted threshold, determining its colour by an interpolation
// algorithm."  [0060]: also if it is equal.
TEST(Claim, C07_ASmallColourDifferenceIsInterpolated) {
  const sim::FrameOutcome outcome = exact();
  int equal = 0, interpolated = 0;
  for (const SeenCandidate& c : candidates_of(outcome)) {
    SCOPED_TRACE(at_text(c.x, c.y));
    ASSERT_EQ(c.pairs.size(), 1u);
    const auto [a, b] = c.pairs[0];
    if (channel_difference(*a, *b) > c.record.threshold) continue;
    equal += channel_difference(*a, *b) == c.record.threshold;
    ++interpolated;
    EXPECT_EQ(c.record.decision, hw::Decision::interpolated);
    EXPECT_EQ(c.record.r, (a->r + b->r + 1) / 2);
    EXPECT_EQ(c.record.g, (a->g + b->g + 1) / 2);
    EXPECT_EQ(c.record.b, (a->b + b->b + 1) / 2);
    EXPECT_EQ(c.record.hit_class, hw::HitClass::none) << "it has no ray";
    EXPECT_EQ(c.record.primitive, -1);
  }
  EXPECT_GT(equal, 0);
  EXPECT_EQ(counter(outcome, "render_executor", "interpolated"), static_cast<std::uint64_t>(interpolated));
}

// "[...] if the colour difference [...] is larger than the adjusted threshold, determining its colour by ray tracing."
TEST(Claim, C08_ALargeColourDifferenceIsRayTraced) {
  const sim::FrameOutcome outcome = exact(), full = exact(traced_everywhere());
  int traced = 0;
  for (const SeenCandidate& c : candidates_of(outcome)) {
    SCOPED_TRACE(at_text(c.x, c.y));
    ASSERT_EQ(c.pairs.size(), 1u);
    if (channel_difference(*c.pairs[0].first, *c.pairs[0].second) <= c.record.threshold) continue;
    ++traced;
    const hw::PixelRecord& own = record_at(full, c.x, c.y);
    EXPECT_EQ(c.record.decision, hw::Decision::traced);
    EXPECT_TRUE(same_color(c.record, own)) << "not the colour that tracing it gives";
    EXPECT_EQ(c.record.hit_class, own.hit_class);
    EXPECT_EQ(c.record.primitive, own.primitive);
    EXPECT_EQ(c.record.t_bits, own.t_bits);
  }
  EXPECT_GT(traced, 0);
  EXPECT_EQ(outcome.rays_primary, 33u * 25u + static_cast<std::uint64_t>(traced));
}

// "[...] providing the second image as the result of rendering the scene when selective rendering is complete for all
// candidate pixels."  [0074]: one for each frame, and the same for the next.
TEST(Claim, C09_TheSecondImageIsTheFrameWhenAllCandidatesAreDone) {
  Recipe recipe = attention_recipe();
  recipe.frames = 3;
  const Rendered r = run(make_scene(recipe));
  expect_exact(r);
  ASSERT_EQ(r.outcomes.size(), 3u);
  for (const sim::FrameOutcome& outcome : r.outcomes) {
    const std::uint64_t candidates = counter(outcome, "candidate_pixel_extractor", "candidates");
    EXPECT_EQ(candidates, 65u * 49u - 33u * 25u);
    EXPECT_EQ(candidates,
              counter(outcome, "render_executor", "interpolated") + counter(outcome, "render_executor", "traced"));
    EXPECT_EQ(counter(outcome, "frame_writer", "pixels"), 65u * 49u);
    for (const hw::PixelRecord& p : outcome.pixels) EXPECT_EQ(p.written, 1);
  }
  EXPECT_NE(all_pixels(r.outcomes[0]), all_pixels(r.outcomes[1]));
}

}  // namespace
}  // namespace artu::golden_tests
