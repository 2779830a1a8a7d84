// Numbers as colours.
#pragma once

#include "sim/report/color.h"

namespace artu::sim {

/// 0 to 1: from blue over purple, red and yellow to white.  Values beyond count as 0 or 1.
Color heat_color(double x);

/// The scales of the maps: a colour of heat_color for ...
Color error_heat(int difference);  // of two codes, 0 ... 255: black for 0, then by its logarithm, 1 blue, 255 white
Color code_heat(int code);         // a threshold or difference, 0 ... 255: log2(1 + code) / 8
Color cycles_heat(std::uint32_t cycles);  // by its logarithm: 100 and below blue, 10000 and above white

/// Where two pictures of one size differ: error_heat of the largest difference of a channel.
Image heat_map(const Image& a, const Image& b);

}  // namespace artu::sim
