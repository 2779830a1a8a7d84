#include "hw/selective/candidate_pixel_extractor.h"

namespace artu::hw {

void CandidatePixelExtractor::reset() {
  active_ = false;
  first_ = open_ = fetching_ = 0;
  candidates_ = spans_ = 0;
}

TileWalk CandidatePixelExtractor::walk(std::uint32_t pass, std::uint32_t width, std::uint32_t height,
                                       std::uint32_t tile) {
  return pass == 1 ? TileWalk(width, height, tile, 1, 2, 0, 2) : TileWalk(width, height, tile, 0, 1, 1, 2);
}

/// The lines of a row that hold the span and one pixel on either side.
void CandidatePixelExtractor::want_row(Window& window, std::uint32_t y) {
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint32_t begin = window.span.begin == 0 ? 0 : window.span.begin - 1;
  const std::uint32_t last = std::min(window.span.end, frame.width - 1);
  const std::uint64_t row = std::uint64_t{y} * frame.pitch;
  for (Address a = line_of(frame.frame_buffer + (row + begin) * 4); a <= frame.frame_buffer + (row + last) * 4;
       a += line_bytes) {
    window.lines.push_back(a);
  }
  for (Address a = line_of(frame.hit_classes + row + begin); a <= frame.hit_classes + row + last; a += line_bytes) {
    window.lines.push_back(a);
  }
}

void CandidatePixelExtractor::open_window() {
  Window& window = window_[open_++ % windows];
  window.span = walk_.span();
  window.lines.clear();
  window.issued = window.answered = 0;
  if (pass_ == 1) {
    want_row(window, window.span.y);
  } else {
    want_row(window, window.span.y - 1);
    if (window.span.y + 1 < registers_.descriptor.height) want_row(window, window.span.y + 1);
  }
  if (open_ - first_ == 1) x_ = window.span.begin;
  walk_.next();
  ++spans_;
}

/// The hit class of a neighbour as far as it counts: inside the image and ray traced in an earlier pass.
HitClass CandidatePixelExtractor::counted_class(std::int64_t x, std::int64_t y) const {
  const FrameDescriptor& frame = registers_.descriptor;
  if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) return HitClass::none;
  const unsigned pass_of_neighbour = y % 2 != 0 ? 2 : x % 2 != 0 ? 1 : 0;
  if (pass_of_neighbour >= pass_) return HitClass::none;
  return static_cast<HitClass>(image_.at<std::uint8_t>(frame.hit_classes + static_cast<std::uint64_t>(y) * frame.pitch +
                                                       static_cast<std::uint64_t>(x)));
}

Rgb CandidatePixelExtractor::color(std::uint32_t x, std::uint32_t y) const {
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint8_t* bytes = &image_.at<std::uint8_t>(frame.frame_buffer + (std::uint64_t{y} * frame.pitch + x) * 4);
  return {bytes[0], bytes[1], bytes[2]};
}

Candidate CandidatePixelExtractor::candidate(std::uint32_t x, std::uint32_t y) const {
  const FrameDescriptor& frame = registers_.descriptor;
  Candidate c;
  c.x = static_cast<std::uint16_t>(x);
  c.y = static_cast<std::uint16_t>(y);
  c.pass = pass_;
  std::size_t i = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx != 0 || dy != 0) c.neighbours[i++] = counted_class(std::int64_t{x} + dx, std::int64_t{y} + dy);
    }
  }
  // A candidate is never on the left or upper border, where its index is odd.
  c.pair = pass_ == 1 ? x + 1 < frame.width : y + 1 < frame.height;
  if (c.pair) {
    c.a = pass_ == 1 ? color(x - 1, y) : color(x, y - 1);
    c.b = pass_ == 1 ? color(x + 1, y) : color(x, y + 1);
  }
  return c;
}

Activity CandidatePixelExtractor::tick(Cycle now) {
  bool moved = false, blocked_mem = false, blocked_out = false;
  if (memory_->response.can_pop()) {
    // The tag is the window's number in the ring.
    ++window_[memory_->response.front().tag].answered;
    memory_->response.pop();
    moved = true;
  }
  if (!active_ && command_->can_pop()) {
    pass_ = command_->front().pass;
    command_->pop();
    const FrameDescriptor& frame = registers_.descriptor;
    walk_ = walk(pass_, frame.width, frame.height, config_.tile);
    // The pass before has written the frame buffer: what the cache holds of it is old.
    pixel_cache_.invalidate();
    active_ = true;
    moved = true;
  }
  if (active_ && !walk_.done() && open_ - first_ < windows) {
    open_window();
    moved = true;
  }
  if (fetching_ != open_) {
    Window& window = window_[fetching_ % windows];
    if (memory_->request.can_push()) {
      memory_->request.push({window.lines[window.issued++], 0, static_cast<std::uint32_t>(fetching_ % windows), 0});
      if (window.issued == window.lines.size()) ++fetching_;
      moved = true;
    } else {
      blocked_mem = true;
    }
  }
  if (first_ != open_) {
    Window& window = window_[first_ % windows];
    if (window.issued != window.lines.size() || window.answered != window.lines.size()) {
      blocked_mem = true;
    } else if (!out_->can_push()) {
      blocked_out = true;
    } else {
      out_->push(candidate(x_, window.span.y));
      ++candidates_;
      moved = true;
      x_ += walk_.dx();
      if (x_ >= window.span.end) {
        ++first_;
        if (first_ != open_) x_ = window_[first_ % windows].span.begin;
      }
    }
  } else if (active_ && walk_.done()) {
    active_ = false;
    moved = true;
  }
  if (moved) return {State::busy, now + 1};
  if (blocked_out) return {State::stall_out};
  if (blocked_mem) return {State::stall_mem};
  return {State::stall_in};
}

void CandidatePixelExtractor::report(Statistics& out) const {
  out.push_back({path(), "candidates", candidates_, "pixels", "candidate pixels handed on"});
  out.push_back({path(), "spans", spans_, "", "rows of tiles whose lines were fetched"});
}

std::string CandidatePixelExtractor::describe() const {
  return "pass " + std::to_string(pass_) + ", " + std::to_string(open_ - first_) + " spans open, " +
         std::to_string(candidates_) + " candidates handed on";
}

}  // namespace artu::hw
