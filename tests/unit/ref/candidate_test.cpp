// What a policy is given, and the settings that are refused.
#include "unit/ref/canvas.h"

namespace artu::ref {
namespace {

// Colours and classes of a 3 x 3 image: red is 10 times the place in it, the classes by turns.
struct Nine {
  std::vector<Pixel> pixels{9};
  Image image{3, 3, pixels};

  Nine() {
    for (std::size_t i = 0; i < 9; ++i) {
      pixels[i].r = static_cast<std::uint8_t>(10 * i);
      pixels[i].hit_class = i % 2 != 0 ? HitClass::static_geometry : HitClass::dynamic_geometry;
    }
  }
};

std::string finished(const Candidate& candidate) {
  std::string text;
  for (const Neighbour& n : candidate.ring) text += n.finished ? 'f' : '.';
  return text;
}

TEST(Candidate, SeesNothingOfItsOwnPassAndLater) {
  Nine nine;
  const Candidate top = candidate_at({}, nine.image, 1, 0);
  EXPECT_EQ(finished(top), "...ff...");
  EXPECT_EQ(top.ring[5].color.r, 0);
  EXPECT_EQ(top.ring[5].hit_class, HitClass::none);
  const Candidate centre = candidate_at({}, nine.image, 1, 1);
  EXPECT_EQ(finished(centre), "fff..fff");
  EXPECT_EQ(centre.place.kind, PassKind::vertical);
  EXPECT_EQ(centre.n_static, 2);
  EXPECT_EQ(centre.n_dynamic, 4);
  EXPECT_EQ(centre.pairs, 1);
  EXPECT_EQ(centre.pair[0].a.r, 10);
  EXPECT_EQ(centre.pair[0].b.r, 70);
  EXPECT_EQ(centre.difference, 60);
}

TEST(Candidate, ACentreHasTwoPairsAndAllNeighbours) {
  Nine nine;
  Settings s;
  s.passes = Passes::average;
  EXPECT_EQ(finished(candidate_at(s, nine.image, 0, 1)), ".ff...ff");  // right of it is the centre
  const Candidate centre = candidate_at(s, nine.image, 1, 1);
  EXPECT_EQ(centre.place.kind, PassKind::centre);
  EXPECT_EQ(finished(centre), "ffffffff");
  EXPECT_EQ(centre.n_static, 4);
  EXPECT_EQ(centre.n_dynamic, 4);
  EXPECT_EQ(centre.pairs, 2);
  EXPECT_EQ(centre.pair[0].a.r, 30);
  EXPECT_EQ(centre.pair[0].b.r, 50);
  EXPECT_EQ(centre.pair[1].a.r, 10);
  EXPECT_EQ(centre.pair[1].b.r, 70);
  EXPECT_EQ(centre.difference, 20 + 60);
}

TEST(Candidate, WithoutAPartOfAPairHasNone) {
  std::vector<Pixel> pixels(6, Pixel());
  for (Pixel& pixel : pixels) pixel.r = 9;
  const Image image{3, 2, pixels};
  Settings s;
  s.passes = Passes::average;
  const Candidate centre = candidate_at(s, image, 1, 1);  // left and right are there, below is not
  EXPECT_EQ(centre.pairs, 0);
  EXPECT_EQ(centre.difference, -1);
  EXPECT_EQ(centre.pair[0].a.r, 0);
  EXPECT_EQ(centre.ring[3].color.r, 9);
}

TEST(Candidate, LooksAsFarAsTheLevel) {
  std::vector<Pixel> pixels(81);
  const Image image{9, 9, pixels};
  for (std::size_t i = 0; i < 81; ++i) pixels[i].r = static_cast<std::uint8_t>(i);
  Settings s;
  s.stride = 8;
  const Candidate candidate = candidate_at(s, image, 4, 0);
  EXPECT_EQ(candidate.place.h, 4u);
  EXPECT_EQ(candidate.pair[0].a.r, 0);
  EXPECT_EQ(candidate.pair[0].b.r, 8);
  const Candidate inner = candidate_at(s, image, 4, 2);
  EXPECT_EQ(inner.place.h, 2u);
  EXPECT_EQ(inner.pair[0].a.r, 4);
  EXPECT_EQ(inner.pair[0].b.r, 4 * 9 + 4);
  EXPECT_EQ(inner.ring[0].color.r, 2);
}

TEST(Metric, OfTwoColours) {
  const Color a{10, 200, 30}, b{20, 190, 60};
  EXPECT_EQ(difference_of(Metric::max_channel, a, b), 30);
  EXPECT_EQ(difference_of(Metric::sum, a, b), 50);
  // (770 + 30000 + 870 + 128) >> 8 = 124, (1540 + 28500 + 1740 + 128) >> 8 = 124
  EXPECT_EQ(difference_of(Metric::luma, a, b), 0);
  const Color black{0, 0, 0}, white{255, 255, 255};
  EXPECT_EQ(difference_of(Metric::max_channel, black, white), 255);
  EXPECT_EQ(difference_of(Metric::sum, white, black), 765);
  EXPECT_EQ(difference_of(Metric::luma, black, white), 255);
  EXPECT_EQ(difference_of(Metric::luma, {0, 1, 0}, {0, 0, 0}), 1);  // 278 >> 8
  EXPECT_EQ(difference_of(Metric::luma, {0, 0, 128}, black), 15);   // 14.5 + 0.5
}

TEST(Settings, ThatMakeNoSenseAreRefused) {
  const auto with = [](auto change) {
    Settings s;
    change(s);
    return s;
  };
  EXPECT_NO_THROW(check({}));
  for (int stride : {-2, 0, 1, 3, 5, 6, 16}) {
    EXPECT_THROW(check(with([&](Settings& s) { s.stride = stride; })), std::invalid_argument) << stride;
  }
  EXPECT_THROW(check(with([](Settings& s) { s.count = Count::merged; })), std::invalid_argument);
  EXPECT_NO_THROW(check(with([](Settings& s) {
    s.count = Count::merged;
    s.compare = Compare::reference_count;
  })));
  for (int count : {-1, 9}) {
    EXPECT_THROW(check(with([&](Settings& s) { s.reference_count = count; })), std::invalid_argument) << count;
  }
  EXPECT_THROW(check(with([](Settings& s) { s.policy = ""; })), std::invalid_argument);
  const traces::Scene scene;
  EXPECT_THROW(Golden(scene, with([](Settings& s) { s.stride = 3; })), std::invalid_argument);
}

}  // namespace
}  // namespace artu::ref
