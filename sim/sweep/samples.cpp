#include "sim/sweep/samples.h"

#include <boost/random/sobol.hpp>
#include <numeric>

#include "sim/stress/random.h"

namespace artu::sim {
namespace {

/// [0, 1) in steps of 2^-53.
double share_of(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

}  // namespace

Samples latin_hypercube(std::uint32_t count, std::size_t dimensions, std::uint64_t seed) {
  Samples samples(count, std::vector<double>(dimensions));
  for (std::size_t d = 0; d < dimensions; ++d) {
    Random random(seed, d);  // a stream of its own: a further axis leaves the others as they were
    std::vector<std::uint32_t> parts(count);
    std::iota(parts.begin(), parts.end(), 0);
    for (std::uint32_t i = count; i > 1; --i) std::swap(parts[i - 1], parts[random.below(i)]);
    for (std::uint32_t i = 0; i < count; ++i) samples[i][d] = (parts[i] + share_of(random.next())) / count;
  }
  return samples;
}

Samples sobol(std::uint32_t count, std::size_t dimensions, std::uint64_t seed) {
  Samples samples(count, std::vector<double>(dimensions));
  if (dimensions == 0) return samples;
  std::vector<std::uint64_t> shift(dimensions, 0);
  for (std::size_t d = 0; seed != 0 && d < dimensions; ++d) shift[d] = Random(seed, d).next();
  boost::random::sobol sequence(dimensions);
  for (std::uint32_t i = 0; i < count; ++i) {
    // Boost's begins with the second point; without the first, the origin, 2^m points would not be balanced.
    for (std::size_t d = 0; d < dimensions; ++d) samples[i][d] = share_of((i == 0 ? 0 : sequence()) ^ shift[d]);
  }
  return samples;
}

}  // namespace artu::sim
