#include "sim/compare/image_metrics.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <vector>

namespace artu::sim {
namespace {

constexpr std::uint32_t window = ssim_window;
constexpr double sigma = 1.5;
constexpr double c1 = (0.01 * 255) * (0.01 * 255), c2 = (0.03 * 255) * (0.03 * 255);

std::array<double, window> gaussian() {
  std::array<double, window> weights;
  double sum = 0;
  for (std::uint32_t i = 0; i < window; ++i) {
    const int from_center = static_cast<int>(i) - static_cast<int>(window / 2);
    const double d = from_center;
    sum += weights[i] = std::exp(-d * d / (2 * sigma * sigma));
  }
  for (double& w : weights) w /= sum;
  return weights;
}

/// The window's weighted sums of a, b, a*a, b*b and a*b.
struct Moments {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  void add(double w, const Moments& m) { a += w * m.a, b += w * m.b, aa += w * m.aa, bb += w * m.bb, ab += w * m.ab; }
};

double similarity(const Moments& m) {
  const double var_a = m.aa - m.a * m.a, var_b = m.bb - m.b * m.b, cov = m.ab - m.a * m.b;
  return (2 * m.a * m.b + c1) * (2 * cov + c2) / ((m.a * m.a + m.b * m.b + c1) * (var_a + var_b + c2));
}

/// Adds a third of the channel's.  The window is separable: rows are filtered as they come, and the last 11 kept for
/// the columns.
void add_ssim_of_channel(const Image& a, const Image& b, unsigned channel, std::vector<double>& map) {
  const std::array<double, window> weights = gaussian();
  const std::uint32_t columns = a.width - window + 1;
  std::array<std::vector<Moments>, window> rows;
  for (auto& row : rows) row.resize(columns);
  for (std::uint32_t y = 0; y < a.height; ++y) {
    std::vector<Moments>& row = rows[y % window];
    const std::size_t start = std::size_t{y} * a.width;
    for (std::uint32_t x = 0; x < columns; ++x) {
      Moments m;
      for (std::uint32_t i = 0; i < window; ++i) {
        const double va = a.rgb[3 * (start + x + i) + channel], vb = b.rgb[3 * (start + x + i) + channel];
        m.add(weights[i], {va, vb, va * va, vb * vb, va * vb});
      }
      row[x] = m;
    }
    if (y + 1 < window) continue;
    for (std::uint32_t x = 0; x < columns; ++x) {
      Moments m;
      for (std::uint32_t i = 0; i < window; ++i) m.add(weights[i], rows[(y + 1 + i) % window][x]);
      map[std::size_t{y + 1 - window} * columns + x] += similarity(m) / 3;
    }
  }
}

}  // namespace

double psnr_of(std::uint64_t squares, std::uint64_t pixels) {
  if (squares == 0) return std::numeric_limits<double>::infinity();
  return 10 * std::log10(255.0 * 255.0 * 3 * static_cast<double>(pixels) / static_cast<double>(squares));
}

std::vector<double> ssim_map(const Image& a, const Image& b) {
  if (a.width < window || a.height < window) return {};
  std::vector<double> map(std::size_t{a.width - window + 1} * (a.height - window + 1));
  for (unsigned channel = 0; channel < 3; ++channel) add_ssim_of_channel(a, b, channel, map);
  return map;
}

ImageDifference compare_images(const Image& a, const Image& b) {
  ImageDifference result;
  result.pixels = std::uint64_t{a.width} * a.height;
  for (std::size_t i = 0; i < result.pixels; ++i) {
    unsigned of_pixel = 0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      const auto d = static_cast<unsigned>(std::abs(int{a.rgb[c]} - int{b.rgb[c]}));
      result.squares += d * d;
      of_pixel = std::max(of_pixel, d);
    }
    result.differing += of_pixel != 0;
    result.largest = std::max(result.largest, of_pixel);
  }
  result.psnr = psnr_of(result.squares, result.pixels);
  const std::vector<double> similarities = ssim_map(a, b);
  result.ssim = std::accumulate(similarities.begin(), similarities.end(), 0.0) /
                static_cast<double>(similarities.size());  // NaN without a window
  return result;
}

}  // namespace artu::sim
