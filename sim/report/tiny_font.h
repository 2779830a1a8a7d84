// Letters for the captions of pictures: 5 x 7 pixels, one between them.
#pragma once

#include <string>

#include "sim/report/color.h"
#include "sim/report/image.h"

namespace artu::sim {

inline constexpr std::uint32_t letter_width = 6, letter_height = 7;  // the width has the gap

/// Width of a text in pixels.
inline std::uint32_t text_width(const std::string& text) {
  return static_cast<std::uint32_t>(text.size()) * letter_width;
}

/// With (x, y) the upper left corner.  There are capitals alone: small letters become capitals.  What has no letter is
/// left out, what lies outside the picture is not drawn.
void draw_text(Image& image, std::uint32_t x, std::uint32_t y, const std::string& text, Color color);

}  // namespace artu::sim
