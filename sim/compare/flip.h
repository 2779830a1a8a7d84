// LDR-FLIP: the difference that somebody sees who alternates between two pictures.
//
// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. D. Fairchild: "FLIP: A Difference Evaluator
// for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), HPG 2020.  Its constants stand in flip.cpp.
#pragma once

#include <vector>

#include "sim/report/image.h"

namespace artu::sim {

/// Of a display 0.7 m wide with 3840 pixels, seen from 0.7 m: the authors' default, 67 in the paper.
inline constexpr double flip_pixels_per_degree = 3840 * 3.14159265358979323846 / 180;

/// A value a pixel, row 0 first: 0 is no visible difference, 1 the largest.  Both pictures must have one size.
std::vector<double> flip_map(const Image& reference, const Image& test,
                             double pixels_per_degree = flip_pixels_per_degree);

/// The mean of the map.
double flip_of(const Image& reference, const Image& test, double pixels_per_degree = flip_pixels_per_degree);

}  // namespace artu::sim
