// The colour spaces of FLIP, with D65 white and the matrix that the authors' program has.
#pragma once

#include <array>
#include <cstdint>

namespace artu::sim {

using Triple = std::array<double, 3>;

/// An 8-bit sRGB code to linear light, 0 ... 1 (IEC 61966-2-1).
double linear_of(std::uint8_t code);

/// Linear RGB to YCxCz: Lab's opponent axes without its cube root, so that filters over it add light.
Triple ycxcz_of(const Triple& linear_rgb);
Triple linear_rgb_of_ycxcz(const Triple& ycxcz);

/// CIELAB with a and b scaled by L / 100: colours of dark places count less (Hunt's effect).
Triple hunt_lab_of(const Triple& linear_rgb);

}  // namespace artu::sim
