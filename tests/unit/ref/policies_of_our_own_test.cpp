// contrast and decisions, by hand from docs/selective-rendering.md, "Policies of our own".
#include "unit/ref/canvas.h"

namespace artu::ref {
namespace {

int threshold_of(const Settings& settings, const Candidate& candidate) {
  return policy_named(settings.policy)(candidate, settings);
}

Settings settings_of(const std::string& policy, int stride = 2, Passes passes = Passes::horizontal_vertical) {
  Settings s;
  s.policy = policy;
  s.reference = 100;
  s.stride = stride;
  s.passes = passes;
  return s;
}

void finish(Candidate& candidate, std::size_t place, Color color, HitClass hit_class = HitClass::none) {
  candidate.ring[place] = {true, color, hit_class};
}

Candidate with_dynamic(Candidate candidate, int n_dynamic = 1) {
  candidate.n_dynamic = n_dynamic;
  return candidate;
}

Color red(int code) { return {static_cast<std::uint8_t>(code), 0, 0}; }

/// A candidate with the side above alone.
Candidate below(Color a, Color m, Color b) {
  Candidate candidate;
  finish(candidate, 0, a);
  finish(candidate, 1, m);
  finish(candidate, 2, b);
  return candidate;
}

/// Threshold of a pixel in an image of red codes, a row of them after the other.
int threshold_in(const Settings& settings, std::uint32_t width, const std::vector<int>& codes, std::uint32_t x,
                 std::uint32_t y) {
  std::vector<Pixel> pixels(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) pixels[i].r = static_cast<std::uint8_t>(codes[i]);
  const Image image{width, static_cast<std::uint32_t>(codes.size()) / width, pixels};
  return threshold_of(settings, candidate_at(settings, image, x, y));
}

/// Threshold of a pixel in a black image of hit classes, a letter each: m s d, and . where interpolated.
int threshold_in(const Settings& settings, const std::vector<std::string>& rows, std::uint32_t x, std::uint32_t y) {
  std::vector<Pixel> pixels;
  for (const std::string& row : rows) {
    for (char c : row) {
      pixels.emplace_back();
      pixels.back().hit_class = c == 's'   ? HitClass::static_geometry
                                : c == 'd' ? HitClass::dynamic_geometry
                                : c == 'm' ? HitClass::miss
                                           : HitClass::none;
    }
  }
  const Image image{static_cast<std::uint32_t>(rows[0].size()), static_cast<std::uint32_t>(rows.size()), pixels};
  return threshold_of(settings, candidate_at(settings, image, x, y));
}

// ---- contrast

TEST(Contrast, EachSideCountsOnceItsThreeAreFinished) {
  const Settings s = settings_of("contrast");
  EXPECT_EQ(threshold_of(s, {}), 100);
  const std::size_t sides[4][3] = {{0, 1, 2}, {5, 6, 7}, {0, 3, 5}, {2, 4, 7}};
  for (const auto& side : sides) {
    for (HitClass middle : {HitClass::none, HitClass::static_geometry}) {
      Candidate candidate;
      finish(candidate, side[0], red(10));
      finish(candidate, side[1], red(60), middle);
      finish(candidate, side[2], red(30));
      EXPECT_EQ(threshold_of(s, candidate), 60) << side[1];  // e = 120 - 40 = 80, times 8 / 16
      for (std::size_t missing : side) {
        Candidate without = candidate;
        without.ring[missing].finished = false;
        EXPECT_EQ(threshold_of(s, without), 100) << side[1] << " without " << missing;
      }
    }
  }
}

TEST(Contrast, TheWorstChannelOfASide) {
  const Settings s = settings_of("contrast");
  // 40 - 40 = 0, 14 - 0 = 14, abs(40 - 99) = 59; 472 / 16 = 29.5
  EXPECT_EQ(threshold_of(s, below({10, 0, 50}, {20, 7, 20}, {30, 0, 49})), 71);
  EXPECT_EQ(threshold_of(s, below({0, 0, 0}, {0, 7, 0}, {0, 0, 0})), 93);            // 14
  EXPECT_EQ(threshold_of(s, below({0, 0, 0}, {20, 7, 9}, {0, 0, 0})), 80);           // 40
  EXPECT_EQ(threshold_of(s, below({10, 20, 30}, {20, 30, 40}, {30, 40, 50})), 100);  // a slope is no edge
}

TEST(Contrast, TheWorstSide) {
  Settings s = settings_of("contrast");
  Candidate candidate;
  const int codes[8] = {10, 20, 10, 50, 30, 30, 0, 0};
  for (std::size_t i = 0; i < 8; ++i) finish(candidate, i, red(codes[i]));
  // above 40 - 20 = 20, below 0 - 30, left 100 - 40 = 60, right 60 - 10 = 50
  EXPECT_EQ(threshold_of(s, candidate), 70);
  s.policy_registers = {3, 0, 0, 0};
  EXPECT_EQ(threshold_of(s, candidate), 89);  // 180 / 16 = 11.25
  s.policy_registers = {1, 0, 0, 0};
  EXPECT_EQ(threshold_of(s, candidate), 97);  // 60 / 16 = 3.75
  s.policy_registers = {16, 0, 0, 0};
  EXPECT_EQ(threshold_of(s, candidate), 40);
  s.policy_registers = {255, 0, 0, 0};
  EXPECT_EQ(threshold_of(s, candidate), 0);
  s.policy_registers = {0, 0, 255, 255};  // not of this policy
  EXPECT_EQ(threshold_of(s, candidate), 70);
}

TEST(Contrast, RoundsDownAndEndsAtZero) {
  Settings s = settings_of("contrast");
  EXPECT_EQ(threshold_of(s, below(red(0), red(0), red(1))), 100);  // 8 / 16
  EXPECT_EQ(threshold_of(s, below(red(1), red(0), red(2))), 99);   // 24 / 16
  EXPECT_EQ(threshold_of(s, below(red(0), red(100), red(0))), 0);  // 200 * 8 / 16 = 100
  EXPECT_EQ(threshold_of(s, below(red(0), red(255), red(0))), 0);
  s.reference = 255;
  EXPECT_EQ(threshold_of(s, below(red(0), red(255), red(0))), 0);  // 510 * 8 / 16 = 255
  s.policy_registers = {7, 0, 0, 0};
  EXPECT_EQ(threshold_of(s, below(red(0), red(255), red(0))), 32);  // 3570 / 16 = 223.1
  EXPECT_EQ(threshold_of(s, below(red(255), red(0), red(255))), 32);
  s.policy_registers = {255, 0, 0, 0};
  EXPECT_EQ(threshold_of(s, below(red(0), red(255), red(0))), 0);
  s.reference = 0;
  EXPECT_EQ(threshold_of(s, {}), 0);
}

TEST(Contrast, SidesOfThePasses) {
  // Worth looking at: above 80 - 40 = 40, below 50, left 90 - 10 = 80, right 80 - 20 = 60.
  const std::vector<int> codes{10, 40, 30, 45, 200, 10, 0, 0, 50};
  const Settings s = settings_of("contrast"), average = settings_of("contrast", 2, Passes::average);
  EXPECT_EQ(threshold_in(s, 3, codes, 1, 0), 100);
  EXPECT_EQ(threshold_in(s, 3, codes, 1, 1), 75);
  EXPECT_EQ(threshold_in(average, 3, codes, 1, 0), 100);
  EXPECT_EQ(threshold_in(average, 3, codes, 1, 1), 60);
  // A horizontal pass inside of an image, and a vertical one between samples.
  const std::vector<int> five{9,  250, 7, 250, 5,   //
                              99, 250, 1, 250, 88,  //
                              0,  250, 9, 250, 30,  //
                              99, 250, 1, 250, 88,  //
                              60, 0,   3, 10,  1};
  EXPECT_EQ(threshold_in(s, 5, five, 1, 2), 100);
  EXPECT_EQ(threshold_in(average, 5, five, 1, 2), 100);
  EXPECT_EQ(threshold_in(s, 5, five, 2, 3), 0);        // above 250, 9, 250
  EXPECT_EQ(threshold_in(average, 5, five, 2, 3), 0);  // the same: left and right are centres, and later
  EXPECT_EQ(threshold_in(s, 5,
                         {9, 60, 7, 50, 5,    //
                          0, 255, 0, 255, 0,  //
                          0, 20, 35, 40, 0},
                         2, 1),
            52);  // above abs(14 - 110) = 96, below 70 - 60 = 10
}

TEST(Contrast, SidesAtTheBorder) {
  const Settings s = settings_of("contrast"), average = settings_of("contrast", 2, Passes::average);
  EXPECT_EQ(threshold_in(s, 3, {10, 40, 30, 255, 255, 255}, 1, 1), 80);          // above alone; it has no pair
  EXPECT_EQ(threshold_in(s, 3, {10, 40, 30, 0, 0, 0, 255, 0, 255}, 0, 1), 100);  // half of it above and below
  EXPECT_EQ(threshold_in(average, 3, {10, 40, 30, 0, 0, 0, 255, 0, 255}, 0, 1), 100);
  EXPECT_EQ(threshold_in(average, 2, {10, 90, 40, 200, 30, 90}, 1, 1), 80);  // left alone: 80 - 40
  EXPECT_EQ(threshold_in(average, 2, {10, 90, 40, 200}, 1, 1), 100);
}

TEST(Contrast, LooksAsFarAsTheLevel) {
  std::vector<int> codes(81, 255);  // where nobody should look
  const auto code = [&](std::size_t x, std::size_t y) -> int& { return codes[y * 9 + x]; };
  for (std::size_t x : {2, 4, 6}) code(x, 0) = code(x, 4) = 0;
  code(2, 0) = 20, code(4, 0) = 90, code(6, 0) = 60;
  code(2, 4) = 30, code(4, 4) = 0, code(6, 4) = 40;
  // Of (4, 2), h = 2: above 180 - 80 = 100, below 70.
  EXPECT_EQ(threshold_in(settings_of("contrast", 8), 9, codes, 4, 2), 50);
  EXPECT_EQ(threshold_in(settings_of("contrast", 8, Passes::average), 9, codes, 4, 2), 50);
  // With a stride of 4 it is of the first level, and looks no farther.
  EXPECT_EQ(threshold_in(settings_of("contrast", 4), 9, codes, 4, 2), 50);
  // Of (4, 4), h = 4: above 255, 90, 255, below 255, 255, 255; left and right are flat.
  EXPECT_EQ(threshold_in(settings_of("contrast", 8), 9, codes, 4, 4), 0);  // 330 * 8 / 16 = 165
  Settings weak = settings_of("contrast", 8, Passes::average);
  weak.policy_registers[0] = 2;
  EXPECT_EQ(threshold_in(weak, 9, codes, 4, 4), 59);  // 660 / 16 = 41.25
}

TEST(Contrast, FallsForAttention) {
  Settings s = settings_of("contrast");
  const Candidate edge = below(red(10), red(60), red(30));
  EXPECT_EQ(threshold_of(s, with_dynamic({})), 67);     // 1200 / 16 - 8
  EXPECT_EQ(threshold_of(s, with_dynamic({}, 8)), 67);  // however many
  Candidate both = with_dynamic({});
  both.n_static = 7;
  EXPECT_EQ(threshold_of(s, both), 67);
  EXPECT_EQ(threshold_of(s, with_dynamic(edge, 3)), 37);  // 60 * 12 / 16 - 8
  // 71 * 12 / 16 = 53.25
  EXPECT_EQ(threshold_of(s, with_dynamic(below({0, 0, 50}, {0, 0, 20}, {0, 0, 49}))), 45);
  s.step = 0;
  EXPECT_EQ(threshold_of(s, with_dynamic(edge)), 45);
  s.policy_registers = {0, 16, 0, 0};  // attention off
  EXPECT_EQ(threshold_of(s, with_dynamic(edge)), 60);
  EXPECT_EQ(threshold_of(s, with_dynamic({})), 100);
  s.step = 5;
  EXPECT_EQ(threshold_of(s, with_dynamic({})), 80);
  s.step = 25;
  EXPECT_EQ(threshold_of(s, with_dynamic({})), 0);
  s.step = 26;
  EXPECT_EQ(threshold_of(s, with_dynamic({})), 0);
  EXPECT_EQ(threshold_of(s, {}), 100);
  s.step = 2;
  s.policy_registers = {0, 1, 0, 0};
  EXPECT_EQ(threshold_of(s, with_dynamic({})), 0);  // 6 - 8
  s.policy_registers = {0, 255, 0, 0};
  EXPECT_EQ(threshold_of(s, with_dynamic({})), 255);  // 1593 - 8
}

TEST(Contrast, IsClampedAtTheEnd) {
  Settings s = settings_of("contrast");
  s.minimum = 10;
  s.maximum = 50;
  EXPECT_EQ(threshold_of(s, {}), 50);
  EXPECT_EQ(threshold_of(s, with_dynamic({})), 50);                              // 67, and not of 50
  EXPECT_EQ(threshold_of(s, below(red(0), red(60), red(0))), 40);                // 100 - 60
  EXPECT_EQ(threshold_of(s, below(red(0), red(255), red(0))), 10);               // 0
  EXPECT_EQ(threshold_of(s, with_dynamic(below(red(0), red(85), red(0)))), 10);  // 15 -> 11 - 8
}

// ---- decisions

TEST(Decisions, AHorizontalPassHasNothingToCount) {
  const Settings s = settings_of("decisions"), average = settings_of("decisions", 2, Passes::average);
  for (const Settings& settings : {s, average}) {
    EXPECT_EQ(threshold_of(settings, {}), 100);
    EXPECT_EQ(threshold_in(settings, {"sssss", "sssss", "sssss", "sssss", "sssss"}, 1, 2), 100);
    EXPECT_EQ(threshold_in(settings, {"sssss", "sssss", "sssss"}, 1, 0), 100);
    EXPECT_EQ(threshold_in(settings, {"ssss"}, 3, 0), 100);
  }
}

TEST(Decisions, BelowASampleFourCount) {
  for (Passes passes : {Passes::horizontal_vertical, Passes::average}) {
    const Settings s = settings_of("decisions", 2, passes);
    const std::string unseen = "ddddd";  // the same pass, or a later one
    EXPECT_EQ(threshold_in(s, {"s.s.s", unseen, "s.s.s"}, 2, 1), 100);
    EXPECT_EQ(threshold_in(s, {"sss.s", unseen, "s.s.s"}, 2, 1), 50);
    EXPECT_EQ(threshold_in(s, {"s.sss", unseen, "s.s.s"}, 2, 1), 50);
    EXPECT_EQ(threshold_in(s, {"s.s.s", unseen, "sss.s"}, 2, 1), 50);
    EXPECT_EQ(threshold_in(s, {"s.s.s", unseen, "s.sss"}, 2, 1), 50);
    EXPECT_EQ(threshold_in(s, {"sssss", unseen, "s.s.s"}, 2, 1), 12);  // 100 / 8 = 12.5
    EXPECT_EQ(threshold_in(s, {"s.sss", unseen, "s.sss"}, 2, 1), 12);
    EXPECT_EQ(threshold_in(s, {"sssss", unseen, "sss.s"}, 2, 1), 12);
    EXPECT_EQ(threshold_in(s, {"sssss", unseen, "sssss"}, 2, 1), 12);
    EXPECT_EQ(threshold_in(s, {"mmm.m", unseen, "m.m.m"}, 2, 1), 50);  // a miss was traced
    // At the border some are not there.
    EXPECT_EQ(threshold_in(s, {"sss.s", unseen, "s.s.s"}, 0, 1), 50);
    EXPECT_EQ(threshold_in(s, {"sss.s", unseen, "sss.s"}, 0, 1), 12);
    EXPECT_EQ(threshold_in(s, {"sss.s", unseen}, 2, 1), 50);
    EXPECT_EQ(threshold_in(s, {"s", "d", "s"}, 0, 1), 100);
  }
}

TEST(Decisions, BetweenSamplesTwoCountTwice) {
  const Settings s = settings_of("decisions");
  EXPECT_EQ(threshold_in(s, {"s.sss", "ddddd", "s.sss"}, 1, 1), 100);
  EXPECT_EQ(threshold_in(s, {"sss.s", "ddddd", "s.s.s"}, 1, 1), 12);
  EXPECT_EQ(threshold_in(s, {"s.s.s", "ddddd", "sss.s"}, 1, 1), 12);
  EXPECT_EQ(threshold_in(s, {"sss.s", "ddddd", "sss.s"}, 1, 1), 12);
  EXPECT_EQ(threshold_in(s, {"sss.s", "ddddd"}, 1, 1), 12);  // one alone is doubled as well
}

TEST(Decisions, OfACentreFourCountOnce) {
  const Settings s = settings_of("decisions", 2, Passes::average);
  EXPECT_EQ(threshold_in(s, {"s.s", ".d.", "s.s"}, 1, 1), 100);
  EXPECT_EQ(threshold_in(s, {"sss", ".d.", "s.s"}, 1, 1), 50);
  EXPECT_EQ(threshold_in(s, {"s.s", "sd.", "s.s"}, 1, 1), 50);
  EXPECT_EQ(threshold_in(s, {"s.s", ".ds", "s.s"}, 1, 1), 50);
  EXPECT_EQ(threshold_in(s, {"s.s", ".d.", "sss"}, 1, 1), 50);
  EXPECT_EQ(threshold_in(s, {"sss", "sd.", "s.s"}, 1, 1), 12);
  EXPECT_EQ(threshold_in(s, {"sss", "sds", "sss"}, 1, 1), 12);
}

TEST(Decisions, ShiftsTheReference) {
  Settings s = settings_of("decisions");
  const auto both = [&](int reference) {
    s.reference = reference;
    return std::pair(threshold_in(s, {"sss.s", "ddddd", "s.s.s"}, 2, 1), threshold_in(s, {"sss", "ddd", "s.s"}, 1, 1));
  };
  EXPECT_EQ(both(0), std::pair(0, 0));
  EXPECT_EQ(both(1), std::pair(0, 0));
  EXPECT_EQ(both(7), std::pair(3, 0));
  EXPECT_EQ(both(8), std::pair(4, 1));
  EXPECT_EQ(both(16), std::pair(8, 2));
  EXPECT_EQ(both(255), std::pair(127, 31));
}

TEST(Decisions, CountsTheLevelAlone) {
  const Settings four = settings_of("decisions", 4), eight = settings_of("decisions", 8);
  const Settings average = settings_of("decisions", 4, Passes::average);
  // Of the first level of 4 all places are even; what is odd is not there yet.
  const std::vector<std::string> first{"ddsds", "ddddd", "ddddd", "ddddd", "sd.ds"};
  // (2, 2) looks at (2, 0) and (2, 4); its corner (0, 0) is dynamic here, so classes meet: (12 * 12) / 16 = 9, and for
  // attention (9 * 12) / 16 - 8 = 6 - 8
  EXPECT_EQ(threshold_in(four, first, 2, 2), 0);
  EXPECT_EQ(threshold_in(four, {"sdsds", "ddddd", "ddddd", "ddddd", "sd.ds"}, 2, 2), 12);
  EXPECT_EQ(threshold_in(four, {"sd.ds", "ddddd", "ddddd", "ddddd", "sd.ds"}, 2, 2), 100);
  EXPECT_EQ(threshold_in(four, {"sdsds", "ddddd", "ddddd", "ddddd", "sd.ds"}, 0, 2), 50);
  EXPECT_EQ(threshold_in(average, {"sdsds", "ddddd", ".ddd.", "ddddd", "sd.ds"}, 2, 2), 50);
  EXPECT_EQ(threshold_in(average, {"sdsds", "ddddd", ".ddds", "ddddd", "sd.ds"}, 2, 2), 12);
  // Then all of the even places are samples, traced by the level before or not.
  const std::vector<std::string> second{"s.s.s", "ddddd", "s.s.s", "ddddd", "s.s.s"};
  for (std::uint32_t x = 0; x < 5; ++x) EXPECT_EQ(threshold_in(four, second, x, 1), 100) << x;
  for (std::uint32_t x : {1u, 3u}) EXPECT_EQ(threshold_in(four, second, x, 2), 100) << x;
  EXPECT_EQ(threshold_in(four, {"sss.s", "ddddd", "s.s.s"}, 2, 1), 50);
  EXPECT_EQ(threshold_in(four, {"sss.s", "ddddd", "s.s.s"}, 1, 1), 12);
  EXPECT_EQ(threshold_in(average, {"s.sss", ".....", "s.s.s"}, 3, 1), 50);
  EXPECT_EQ(threshold_in(average, {"s.sss", "..s..", "s.s.s"}, 3, 1), 12);

  // Of 8: d is where nobody should look.
  const std::vector<std::string> rows{"sdsdsd.ds", "ddddddddd", "ddddddddd", "ddddddddd", "sd.dsd.ds",
                                      "ddddddddd", "ddddddddd", "ddddddddd", "sddd.ddds"};
  EXPECT_EQ(threshold_in(eight, rows, 0, 4), 50);   // (4, 0)
  EXPECT_EQ(threshold_in(eight, rows, 4, 4), 12);   // (4, 0), doubled
  EXPECT_EQ(threshold_in(eight, rows, 4, 2), 50);   // (2, 0); (4, 0) is a sample of the second level
  EXPECT_EQ(threshold_in(eight, rows, 2, 2), 12);   // (2, 0), doubled
  EXPECT_EQ(threshold_in(eight, rows, 6, 2), 100);  // (6, 0) and (6, 4) are interpolated
  EXPECT_EQ(threshold_in(eight, rows, 8, 2), 100);
  EXPECT_EQ(threshold_in(eight, rows, 0, 2), 50);
}

TEST(Decisions, FallsWhereClassesMeet) {
  Settings s = settings_of("decisions");
  const std::vector<std::string> samples{"s.m.s", "ddddd", "s.s.s"};
  EXPECT_EQ(threshold_in(s, samples, 2, 1), 75);
  EXPECT_EQ(threshold_in(s, {"m.s.m", "ddddd", "m.s.m"}, 2, 1), 100);  // the m are too far
  EXPECT_EQ(threshold_in(s, {"m.s.m", "ddddd", "m.s.m"}, 1, 1), 75);   // and here they are not
  EXPECT_EQ(threshold_in(s, {"m.s.m", "ddddd", "m.s.m"}, 1, 0), 75);   // a horizontal pass
  EXPECT_EQ(threshold_in(s, {"s.s.s", "mmmmm", "s.s.s"}, 2, 1), 100);  // not finished
  EXPECT_EQ(threshold_in(s, {"d.d.d", "sssss", "d.d.d"}, 2, 1), 67);   // one class, for attention 75 - 8
  EXPECT_EQ(threshold_in(s, {"s.d.s", "mmmmm", "s.s.s"}, 2, 1), 48);   // 75, then 56 - 8
  EXPECT_EQ(threshold_in(s, {"m.d.m", "sssss", "m.m.m"}, 2, 1), 48);
  EXPECT_EQ(threshold_in(s, {"sms.s", "ddddd", "s.s.s"}, 2, 1), 37);  // 50 * 12 / 16 = 37.5
  EXPECT_EQ(threshold_in(s, {"sms.s", "ddddd", "s.s.s"}, 1, 1), 9);   // 12 * 12 / 16
  s.policy_registers = {16, 0, 0, 0};
  EXPECT_EQ(threshold_in(s, samples, 2, 1), 100);
  s.policy_registers = {5, 0, 0, 0};
  EXPECT_EQ(threshold_in(s, samples, 2, 1), 31);  // 500 / 16 = 31.25
  s.policy_registers = {1, 0, 255, 255};
  EXPECT_EQ(threshold_in(s, samples, 2, 1), 6);
  s.policy_registers = {255, 0, 0, 0};
  EXPECT_EQ(threshold_in(s, samples, 2, 1), 255);  // 25500 / 16 = 1593.75
  EXPECT_EQ(threshold_in(s, {"s.s.s", "ddddd", "s.s.s"}, 2, 1), 100);
}

TEST(Decisions, FallsForAttention) {
  Settings s = settings_of("decisions");
  const std::vector<std::string> all_three{".msd.", "mmmmm", "..s.."};
  EXPECT_EQ(threshold_in(s, all_three, 2, 1), 0);  // T = 2: 12, classes meet: 9, 6 - 8
  s.step = 1;
  EXPECT_EQ(threshold_in(s, all_three, 2, 1), 2);
  s.step = 0;
  EXPECT_EQ(threshold_in(s, all_three, 2, 1), 6);
  s.policy_registers = {0, 16, 0, 0};  // attention off
  EXPECT_EQ(threshold_in(s, all_three, 2, 1), 9);
  s.policy_registers = {16, 16, 0, 0};
  EXPECT_EQ(threshold_in(s, all_three, 2, 1), 12);
  s.policy_registers = {16, 5, 0, 0};
  EXPECT_EQ(threshold_in(s, all_three, 2, 1), 3);  // 60 / 16 = 3.75
  s.policy_registers = {};
  s.step = 2;
  EXPECT_EQ(threshold_in(s, {"ddd.d", "mmmmm", "d.d.d"}, 2, 1), 29);  // T = 1: 50, 37 - 8
  EXPECT_EQ(threshold_of(s, with_dynamic({})), 67);
}

TEST(Decisions, IsClampedAtTheEnd) {
  Settings s = settings_of("decisions");
  s.minimum = 20;
  s.maximum = 40;
  EXPECT_EQ(threshold_in(s, {"s.s.s", "ddddd", "s.s.s"}, 2, 1), 40);
  EXPECT_EQ(threshold_in(s, {"sss.s", "ddddd", "s.s.s"}, 2, 1), 40);  // 50, and not of 40
  EXPECT_EQ(threshold_in(s, {"sms.s", "ddddd", "s.s.s"}, 2, 1), 37);
  EXPECT_EQ(threshold_in(s, {"sssss", "ddddd", "s.s.s"}, 2, 1), 20);
  EXPECT_EQ(threshold_in(s, {"ddd.d", "sssss", "d.d.d"}, 2, 1), 29);
}

// ---- both

TEST(PoliciesOfOurOwn, TakeNoNoticeOfThePatents) {
  Candidate candidate = with_dynamic(below(red(10), red(60), red(30)));
  candidate.difference = 90;
  for (const auto& [policy, threshold] : {std::pair("contrast", 37), std::pair("decisions", 67)}) {
    Settings s = settings_of(policy);
    EXPECT_EQ(threshold_of(s, candidate), threshold);
    s.adaptive = false;
    s.compare = Compare::reference_count;
    s.count = Count::merged;
    s.reference_count = 8;
    s.metric = Metric::sum;
    s.magnitude = Magnitude::progressive;
    s.table = {99, 99, 99, 99, 99, 99, 99, 99};
    EXPECT_EQ(threshold_of(s, candidate), threshold) << policy;
  }
}

// All static; the row below is flat.
const std::vector<int> edge{0,  70, 60, 20, 0,   //
                            15, 50, 44, 22, 14,  //
                            30, 33, 30, 33, 30};

TEST(Contrast, RendersAnEdge) {
  Settings s = settings_of("contrast");
  s.reference = 40;
  Canvas canvas(5, 3);
  canvas.render(s, std::string(15, 's'), edge);
  canvas.expect(1, 0, 1, 2, 0, 40, 60, traced, 70);
  canvas.expect(3, 0, 1, 2, 0, 40, 60, traced, 20);
  canvas.expect(1, 2, 1, 2, 0, 40, 0, interpolated, 30);
  canvas.expect(3, 2, 1, 2, 0, 40, 0, interpolated, 30);
  canvas.expect(0, 1, 2, 3, 0, 40, 30, interpolated, 15);
  canvas.expect(1, 1, 2, 5, 0, 0, 40, traced, 50);         // above 140 - 60 = 80
  canvas.expect(2, 1, 2, 4, 0, 25, 30, traced, 44);        // 120 - 90 = 30
  canvas.expect(3, 1, 2, 5, 0, 30, 10, interpolated, 25);  // 60 - 40 = 20
  canvas.expect(4, 1, 2, 3, 0, 40, 30, interpolated, 15);
  EXPECT_EQ(canvas.traced, 6 + 2 + 2);
}

TEST(Decisions, RendersAnEdge) {
  Settings s = settings_of("decisions");
  s.reference = 40;
  Canvas canvas(5, 3);
  canvas.render(s, std::string(15, 's'), edge);
  canvas.expect(1, 0, 1, 2, 0, 40, 60, traced, 70);
  canvas.expect(3, 2, 1, 2, 0, 40, 0, interpolated, 30);
  canvas.expect(0, 1, 2, 3, 0, 20, 30, traced, 15);
  canvas.expect(1, 1, 2, 5, 0, 5, 40, traced, 50);
  canvas.expect(2, 1, 2, 4, 0, 5, 30, traced, 44);
  canvas.expect(3, 1, 2, 5, 0, 5, 10, traced, 22);
  canvas.expect(4, 1, 2, 3, 0, 20, 30, traced, 14);
  EXPECT_EQ(canvas.traced, 6 + 2 + 5);
}

}  // namespace
}  // namespace artu::ref
