// Points that fill a box evenly.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace artu::sim {

/// Rows of coordinates, each 0 <= x < 1.
using Samples = std::vector<std::vector<double>>;

/// In each coordinate every n-th part of the interval holds one of the n samples (McKay, Beckman and Conover, A
/// Comparison of Three Methods for Selecting Values of Input Variables ..., Technometrics 21, 1979).
Samples latin_hypercube(std::uint32_t count, std::size_t dimensions, std::uint64_t seed);

/// Sobol's sequence with the direction numbers of Joe and Kuo (Constructing Sobol Sequences with Better Two-Dimensional
/// Projections, SIAM J. Sci. Comput. 30, 2008), from its first point on.  A seed other than 0 flips the same random
/// bits in all points (a random digital shift), which keeps them as even.
Samples sobol(std::uint32_t count, std::size_t dimensions, std::uint64_t seed);

}  // namespace artu::sim
