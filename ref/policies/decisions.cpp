// The threshold falls where earlier passes of the level had to trace, and where hits of several classes meet
// (docs/selective-rendering.md, "Policies of our own").
#include "ref/attended.h"

namespace artu::ref::policies {
namespace {

bool was_traced(const Neighbour& neighbour) { return neighbour.finished && neighbour.hit_class != HitClass::none; }

/// `T` of the page.
int traced_in_the_level(const Candidate& candidate) {
  const std::uint32_t h = candidate.place.h, s = 2 * h;
  int traced = 0;
  for (std::size_t i = 0; i < candidate.ring.size(); ++i) {
    if (!was_traced(candidate.ring[i])) continue;
    const auto cell = static_cast<std::uint32_t>(i < 4 ? i : i + 1);  // of 3 x 3, the candidate in its middle
    const std::uint32_t x = candidate.x + cell % 3 * h - h, y = candidate.y + cell / 3 * h - h;
    // Samples were there before the level: that they are traced says nothing of what it had to do.
    traced += x % s != 0 || y % s != 0;
  }
  // Between two columns of samples there are half as many neighbours to count.
  if (candidate.place.kind == PassKind::vertical && candidate.x % s != 0) traced *= 2;
  return traced;
}

bool classes_meet(const Candidate& candidate) {
  HitClass first = HitClass::none;
  for (const Neighbour& neighbour : candidate.ring) {
    if (!was_traced(neighbour)) continue;
    if (first == HitClass::none) first = neighbour.hit_class;
    if (neighbour.hit_class != first) return true;
  }
  return false;
}

}  // namespace

int decisions(const Candidate& candidate, const Settings& settings) {
  const int traced = traced_in_the_level(candidate);
  int evidence = settings.reference >> (traced == 0 ? 0 : traced == 1 ? 1 : 3);
  if (classes_meet(candidate)) evidence = evidence * register_of(settings, 0, 12) >> 4;
  return attended(evidence, candidate, settings);
}

}  // namespace artu::ref::policies
