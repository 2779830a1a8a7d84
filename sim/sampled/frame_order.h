// The order in which the frames of a sequence are drawn for a sample.
//
// Van der Corput's sequence with Owen's scrambling (Randomly Permuted (t,m,s)-Nets, 1995): any number of frames from
// the order's beginning is spread over the sequence, of 2^m frames one lies in each of 2^m equal parts, and each at a
// random place of it.  So the sample is stratified over time however far it goes.
#pragma once

#include <cstdint>
#include <vector>

namespace artu::sim {

/// All of 0 ... count - 1, each once.
std::vector<std::uint32_t> frame_order(std::uint32_t count, std::uint64_t seed);

}  // namespace artu::sim
