// The threshold falls where the neighbours show that interpolating would have gone wrong beside the candidate
// (docs/selective-rendering.md, "Policies of our own").
#include <cstdlib>

#include "ref/attended.h"

namespace artu::ref::policies {
namespace {

// Above, below, left and right, each with its middle between its ends; places in the ring.
constexpr std::size_t sides[4][3] = {{0, 1, 2}, {5, 6, 7}, {0, 3, 5}, {2, 4, 7}};

/// Twice what the mean of `a` and `b` is off `m` by, in the channel where it is worst: no half is lost.
int error_of(Color a, Color m, Color b) {
  return std::max({std::abs(2 * m.r - a.r - b.r), std::abs(2 * m.g - a.g - b.g), std::abs(2 * m.b - a.b - b.b)});
}

/// Of the worst side; the pass and the image's border need no look, as both show in what is finished.
int error_around(const Candidate& candidate) {
  int worst = 0;
  for (const auto& side : sides) {
    const Neighbour &a = candidate.ring[side[0]], &m = candidate.ring[side[1]], &b = candidate.ring[side[2]];
    if (a.finished && m.finished && b.finished) worst = std::max(worst, error_of(a.color, m.color, b.color));
  }
  return worst;
}

}  // namespace

int contrast(const Candidate& candidate, const Settings& settings) {
  const int fall = error_around(candidate) * register_of(settings, 0, 8) >> 4;
  return attended(std::max(settings.reference - fall, 0), candidate, settings);
}

}  // namespace artu::ref::policies
