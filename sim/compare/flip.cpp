#include "sim/compare/flip.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/compare/color_spaces.h"
#include "sim/compare/plane.h"

namespace artu::sim {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double color_exponent = 0.7, feature_exponent = 0.5;  // q_c, q_f
constexpr double p_c = 0.4, p_t = 0.95;                         // how colour differences are spread over 0 ... 1
constexpr double edge_width = 0.082;                            // w: degrees from an edge detector's peak to its trough

/// A contrast sensitivity function in space is a1 sqrt(pi/b1) exp(-pi^2 x^2/b1) + the same of a2, b2; x in degrees.
struct Gaussian {
  double a, b;
};
constexpr Gaussian achromatic{1, 0.0047}, red_green{1, 0.0053}, blue_yellow[2] = {{34.1, 0.04}, {13.5, 0.025}};

double sum_of(const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0); }

Kernel scaled(Kernel kernel, double factor) {
  for (double& w : kernel) w *= factor;
  return kernel;
}

template <class WeightOf>
Kernel kernel_of(int radius, WeightOf weight_of) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(weight_of(x));
  return kernel;
}

/// The Gaussian of one axis, not normalised.  The radius is three standard deviations of the widest of all.
Kernel sensitivity(const Gaussian& g, double pixels_per_degree) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(blue_yellow[0].b / (2 * pi * pi)) * pixels_per_degree));
  return kernel_of(radius, [&](int x) {
    const double degrees = x / pixels_per_degree;
    return std::exp(-pi * pi * degrees * degrees / g.b);
  });
}

Plane blurred(const Plane& plane, const Gaussian& g, double pixels_per_degree) {
  Kernel kernel = sensitivity(g, pixels_per_degree);
  kernel = scaled(kernel, 1 / sum_of(kernel));
  return filtered(plane, kernel, kernel);
}

/// A sum of two Gaussians is not separable, but each of them is.
Plane blurred_blue_yellow(const Plane& plane, double pixels_per_degree) {
  Plane out{plane.width, plane.height, std::vector<double>(plane.values.size())};
  double weight[2], total = 0;
  for (int i = 0; i < 2; ++i) {
    const double sum = sum_of(sensitivity(blue_yellow[i], pixels_per_degree));
    total += weight[i] = blue_yellow[i].a * std::sqrt(pi / blue_yellow[i].b) * sum * sum;
  }
  for (int i = 0; i < 2; ++i) {
    const Plane part = blurred(plane, blue_yellow[i], pixels_per_degree);
    for (std::size_t p = 0; p < out.values.size(); ++p) out.values[p] += weight[i] / total * part.values[p];
  }
  return out;
}

/// Positive weights add up to 1, negative ones to -1.
Kernel balanced(Kernel kernel) {
  double positive = 0, negative = 0;
  for (const double w : kernel) (w > 0 ? positive : negative) += w;
  for (double& w : kernel) w /= w > 0 ? positive : -negative;
  return kernel;
}

/// Length of the two directions' answers: `detector` across, a Gaussian along.
std::vector<double> features(const Plane& y, const Kernel& detector, const Kernel& along) {
  const Plane across_x = filtered(y, detector, along), across_y = filtered(y, along, detector);
  std::vector<double> out(y.values.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::hypot(across_x.values[i], across_y.values[i]);
  return out;
}

/// A picture as it is compared.
struct Seen {
  std::vector<Triple> colors;  // Hunt-adjusted Lab, after the eye's filters
  std::vector<double> edges, points;
};

Seen seen(const Image& image, double pixels_per_degree) {
  const std::size_t pixels = std::size_t{image.width} * image.height;
  double linear[256];
  for (int code = 0; code < 256; ++code) linear[code] = linear_of(static_cast<std::uint8_t>(code));
  Plane planes[3];
  for (Plane& plane : planes) plane = {image.width, image.height, std::vector<double>(pixels)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint8_t* rgb = &image.rgb[3 * i];
    const Triple c = ycxcz_of({linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]});
    for (std::size_t k = 0; k < 3; ++k) planes[k].values[i] = c[k];
  }

  Seen out;
  const Plane filtered_planes[3] = {blurred(planes[0], achromatic, pixels_per_degree),
                                    blurred(planes[1], red_green, pixels_per_degree),
                                    blurred_blue_yellow(planes[2], pixels_per_degree)};
  for (std::size_t i = 0; i < pixels; ++i) {
    Triple rgb =
        linear_rgb_of_ycxcz({filtered_planes[0].values[i], filtered_planes[1].values[i], filtered_planes[2].values[i]});
    for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
    out.colors.push_back(hunt_lab_of(rgb));
  }

  for (double& y : planes[0].values) y = (y + 16) / 116;
  const double deviation = 0.5 * edge_width * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto bell = [&](int x) { return std::exp(-x * x / (2 * deviation * deviation)); };
  Kernel along = kernel_of(radius, bell);
  along = scaled(along, 1 / sum_of(along));
  const Kernel first = balanced(kernel_of(radius, [&](int x) { return -x * bell(x); }));
  const Kernel second =
      balanced(kernel_of(radius, [&](int x) { return (x * x / (deviation * deviation) - 1) * bell(x); }));
  out.edges = features(planes[0], first, along);
  out.points = features(planes[0], second, along);
  return out;
}

/// HyAB, the distance for large colour differences, to the power q_c.
double color_distance(const Triple& a, const Triple& b) {
  return std::pow(std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), color_exponent);
}

}  // namespace

std::vector<double> flip_map(const Image& reference, const Image& test, double pixels_per_degree) {
  const Seen a = seen(reference, pixels_per_degree), b = seen(test, pixels_per_degree);
  const double largest = color_distance(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1})), knee = p_c * largest;
  std::vector<double> map;
  for (std::size_t i = 0; i < a.colors.size(); ++i) {
    const double d = color_distance(a.colors[i], b.colors[i]);
    const double color = d < knee ? p_t / knee * d : p_t + (d - knee) / (largest - knee) * (1 - p_t);
    const double feature = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
    map.push_back(std::pow(color, 1 - std::pow(feature / std::sqrt(2.0), feature_exponent)));
  }
  return map;
}

double flip_of(const Image& reference, const Image& test, double pixels_per_degree) {
  const std::vector<double> map = flip_map(reference, test, pixels_per_degree);
  return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

}  // namespace artu::sim
