#include "sim/report/legend.h"

#include <algorithm>

#include "sim/report/tiny_font.h"

namespace artu::sim {
namespace {

constexpr Color paper{20, 20, 20}, ink{225, 225, 225}, frame{120, 120, 120};
constexpr std::uint32_t margin = 3, line = letter_height + 4, swatch = 9, gap = 8, between = 4;

std::uint32_t width_of(const Legend::Entry& entry) { return swatch + 3 + text_width(entry.text) + gap; }

void draw(Image& image, std::uint32_t x, std::uint32_t y, const Legend::Entry& entry) {
  // A border, for black is a colour too.
  paste(image, blank(swatch, letter_height, frame), x, y);
  paste(image, blank(swatch - 2, letter_height - 2, entry.color), x + 1, y + 1);
  draw_text(image, x + swatch + 3, y, entry.text, ink);
}

}  // namespace

Image with_legend(const Image& image, const Legend& legend) {
  std::uint32_t width = std::max(image.width, text_width(legend.title) + 2 * margin);
  for (const Legend::Entry& entry : legend.entries) width = std::max(width, width_of(entry) + 2 * margin);

  struct Place {
    std::uint32_t x, y;
  };
  std::vector<Place> places;
  Place next{margin + text_width(legend.title) + gap, image.height + margin};
  for (const Legend::Entry& entry : legend.entries) {
    if (next.x + width_of(entry) > width + gap - margin) next = {margin, next.y + line};
    places.push_back(next);
    next.x += width_of(entry);
  }
  Image out = blank(width, next.y + line, paper);
  paste(out, image, 0, 0);
  draw_text(out, margin, image.height + margin, legend.title, ink);
  for (std::size_t i = 0; i < places.size(); ++i) draw(out, places[i].x, places[i].y, legend.entries[i]);
  return out;
}

Image side_by_side(const std::vector<Image>& images) {
  std::uint32_t width = 0, height = 0;
  for (const Image& image : images) {
    width += image.width + (width == 0 ? 0 : between);
    height = std::max(height, image.height);
  }
  Image out = blank(width, height, paper);
  std::uint32_t x = 0;
  for (const Image& image : images) {
    paste(out, image, x, 0);
    x += image.width + between;
  }
  return out;
}

}  // namespace artu::sim
