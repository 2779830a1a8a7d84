#include "ref/policy.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "ref/selective.h"

namespace artu::ref {
namespace {

int threshold_of(const Settings& settings, int n_static, int n_dynamic) {
  Candidate candidate;
  candidate.n_static = n_static;
  candidate.n_dynamic = n_dynamic;
  return policy_named(settings.policy)(candidate, settings);
}

TEST(Attention, MovesByMagnitude) {
  Settings s;
  s.reference = 100;
  s.step = 3;
  s.magnitude = Magnitude::fixed;
  EXPECT_EQ(threshold_of(s, 0, 0), 100);
  EXPECT_EQ(threshold_of(s, 2, 2), 100);
  EXPECT_EQ(threshold_of(s, 0, 4), 97);
  EXPECT_EQ(threshold_of(s, 4, 1), 103);
  s.magnitude = Magnitude::proportional;
  EXPECT_EQ(threshold_of(s, 0, 4), 88);
  EXPECT_EQ(threshold_of(s, 4, 1), 109);
  EXPECT_EQ(threshold_of(s, 8, 0), 124);
  s.magnitude = Magnitude::progressive;
  s.table = {1, 2, 4, 7, 11, 16, 22, 29};
  EXPECT_EQ(threshold_of(s, 0, 1), 99);
  EXPECT_EQ(threshold_of(s, 0, 4), 93);
  EXPECT_EQ(threshold_of(s, 8, 0), 129);
  EXPECT_EQ(threshold_of(s, 3, 3), 100);
}

TEST(Attention, IsClampedAdaptiveOrNot) {
  Settings s;
  s.reference = 16;
  s.step = 10;
  s.minimum = 5;
  s.maximum = 40;
  EXPECT_EQ(threshold_of(s, 0, 4), 5);
  EXPECT_EQ(threshold_of(s, 4, 0), 40);
  s.adaptive = false;
  EXPECT_EQ(threshold_of(s, 0, 4), 16);
  s.reference = 200;
  EXPECT_EQ(threshold_of(s, 0, 4), 40);
  s.reference = 1;
  EXPECT_EQ(threshold_of(s, 0, 0), 5);
}

TEST(Attention, AReferenceCountOfDynamicHits) {
  Settings s;
  s.compare = Compare::reference_count;
  s.reference = 100;
  s.reference_count = 3;
  s.step = 5;
  EXPECT_EQ(threshold_of(s, 8, 3), 100);  // static hits do not matter
  EXPECT_EQ(threshold_of(s, 0, 3), 100);
  EXPECT_EQ(threshold_of(s, 0, 4), 95);
  EXPECT_EQ(threshold_of(s, 0, 8), 75);
  EXPECT_EQ(threshold_of(s, 8, 0), 115);
  s.magnitude = Magnitude::fixed;
  EXPECT_EQ(threshold_of(s, 0, 8), 95);
  EXPECT_EQ(threshold_of(s, 0, 0), 105);
  s.magnitude = Magnitude::progressive;
  EXPECT_EQ(threshold_of(s, 0, 8), 100 - 11);  // the fifth of the table
  EXPECT_EQ(threshold_of(s, 0, 0), 100 + 4);
}

TEST(Attention, AReferenceCountOfAllHits) {
  Settings s;
  s.compare = Compare::reference_count;
  s.count = Count::merged;
  s.reference = 100;
  s.step = 5;
  EXPECT_EQ(threshold_of(s, 1, 1), 100);
  EXPECT_EQ(threshold_of(s, 2, 0), 100);
  EXPECT_EQ(threshold_of(s, 8, 0), 70);
  EXPECT_EQ(threshold_of(s, 0, 1), 105);
  EXPECT_EQ(threshold_of(s, 0, 0), 110);
}

TEST(Attention, TheLargestDifferenceHasAPlaceInTheTable) {
  Settings s;
  s.compare = Compare::reference_count;
  s.magnitude = Magnitude::progressive;
  s.reference = 100;
  s.reference_count = 0;
  EXPECT_EQ(threshold_of(s, 0, 8), 71);
  s.reference_count = 8;
  EXPECT_EQ(threshold_of(s, 0, 0), 129);
}

TEST(Fixed, IsTheClampedReference) {
  Settings s;
  s.policy = "fixed";
  EXPECT_EQ(threshold_of(s, 0, 8), 16);
  EXPECT_EQ(threshold_of(s, 8, 0), 16);
  s.minimum = 20;
  EXPECT_EQ(threshold_of(s, 0, 8), 20);
  s.minimum = 0;
  s.maximum = 9;
  EXPECT_EQ(threshold_of(s, 0, 8), 9);
}

TEST(Policies, AreTheFilesOfTheirFolder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(ARTU_SOURCE_DIR "/ref/policies")) {
    files.push_back(entry.path().stem().string());
  }
  EXPECT_THAT(policy_names(), testing::UnorderedElementsAreArray(files));
  EXPECT_THAT(files, testing::Contains(Settings().policy));
}

TEST(Policies, AnUnknownNameIsRefusedWithAllNames) {
  try {
    policy_named("guess");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("guess"));
    for (const std::string& name : policy_names()) EXPECT_THAT(error.what(), testing::HasSubstr(name));
  }
}

TEST(Policies, AThresholdOutOfRangeIsAnError) {
  std::vector<Pixel> pixels(9);
  const Image image{3, 3, pixels};
  const auto decide_by = [&](Policy policy) { decide({}, policy, image, 1, 0); };
  EXPECT_THROW(decide_by([](const Candidate&, const Settings&) { return -1; }), std::logic_error);
  EXPECT_THROW(decide_by([](const Candidate&, const Settings&) { return 256; }), std::logic_error);
  EXPECT_NO_THROW(decide_by([](const Candidate&, const Settings&) { return 255; }));
}

}  // namespace
}  // namespace artu::ref
