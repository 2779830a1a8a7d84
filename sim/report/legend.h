// A key below a picture: what its colours mean.
#pragma once

#include <string>
#include <vector>

#include "sim/report/color.h"

namespace artu::sim {

struct Legend {
  struct Entry {
    Color color;
    std::string text;
  };
  std::string title;
  std::vector<Entry> entries;
};

/// The picture, unchanged, with the key below it: its pixel (x, y) stays at (x, y).  Entries that do not fit in the
/// width go on the next line; a picture that is narrower than one entry gets a margin on its right.
Image with_legend(const Image& image, const Legend& legend);

/// Next to each other, upper edges in a line.
Image side_by_side(const std::vector<Image>& images);

}  // namespace artu::sim
