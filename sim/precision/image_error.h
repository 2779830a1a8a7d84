// How far pictures are from others, over all frames.
#pragma once

#include <cstdint>

#include "sim/compare/image_metrics.h"

namespace artu::sim {

class ImageError {
 public:
  void add(const ImageDifference& frame);

  double psnr() const;             // dB, of the squares of all frames together; infinity where all pictures are equal
  double ssim() const;             // mean of the frames'; NaN where the pictures are smaller than SSIM's window
  double differing_share() const;  // of the pixels, 0 ... 1
  unsigned largest() const { return largest_; }
  std::uint64_t differing() const { return differing_; }

 private:
  std::uint64_t frames_ = 0, pixels_ = 0, differing_ = 0, squares_ = 0;
  unsigned largest_ = 0;
  double ssim_ = 0;  // sum
};

}  // namespace artu::sim
