// The patent's: the threshold falls where hits are many or dynamic, and rises where they are few or static
// (docs/selective-rendering.md, "One candidate", step 2).
#include "ref/policy.h"

namespace artu::ref::policies {
namespace {

/// Above 0 lowers the threshold, below 0 raises it; the size is `difference` of the page.
int excess_of(const Candidate& candidate, const Settings& settings) {
  if (settings.compare == Compare::dynamic_vs_static) return candidate.n_dynamic - candidate.n_static;
  const int count = settings.count == Count::merged ? candidate.n_static + candidate.n_dynamic : candidate.n_dynamic;
  return count - settings.reference_count;
}

int move_of(int difference, const Settings& settings) {
  switch (settings.magnitude) {
    case Magnitude::fixed:
      return settings.step;
    case Magnitude::proportional:
      return settings.step * difference;
    case Magnitude::progressive:
      break;
  }
  return settings.table[static_cast<std::size_t>(difference - 1)];
}

}  // namespace

int attention(const Candidate& candidate, const Settings& settings) {
  int threshold = settings.reference;
  if (settings.adaptive) {
    const int excess = excess_of(candidate, settings);
    if (excess > 0) threshold -= move_of(excess, settings);
    if (excess < 0) threshold += move_of(-excess, settings);
  }
  return clamped(threshold, settings);
}

}  // namespace artu::ref::policies
