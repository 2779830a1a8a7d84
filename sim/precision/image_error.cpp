#include "sim/precision/image_error.h"

#include <algorithm>

namespace artu::sim {

void ImageError::add(const ImageDifference& frame) {
  ++frames_;
  pixels_ += frame.pixels;
  differing_ += frame.differing;
  squares_ += frame.squares;
  largest_ = std::max(largest_, frame.largest);
  ssim_ += frame.ssim;
}

double ImageError::psnr() const { return psnr_of(squares_, pixels_); }
double ImageError::ssim() const { return ssim_ / static_cast<double>(frames_); }
double ImageError::differing_share() const { return static_cast<double>(differing_) / static_cast<double>(pixels_); }

}  // namespace artu::sim
