#include "hw/selective/candidate_pixel_extractor.h"

namespace artu::hw {

void CandidatePixelExtractor::reset() {
  active_ = false;
  first_ = open_ = fetching_ = 0;
  candidates_ = spans_ = 0;
}

/// The lines of a row that hold the span and `h` pixels on either side.
void CandidatePixelExtractor::want_row(Window& window, std::uint32_t y) {
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint32_t begin = window.span.begin - std::min(window.span.begin, pass_.h);
  const std::uint32_t last_candidate = window.span.end - 1 - (window.span.end - 1 - window.span.begin) % pass_.dx;
  const std::uint32_t last = std::min(last_candidate + pass_.h, frame.width - 1);
  const std::uint64_t row = std::uint64_t{y} * frame.pitch;
  for (Address a = line_of(frame.frame_buffer + (row + begin) * 4); a <= frame.frame_buffer + (row + last) * 4;
       a += line_bytes) {
    window.lines.push_back(a);
  }
  for (Address a = line_of(frame.hit_classes + row + begin); a <= frame.hit_classes + row + last; a += line_bytes) {
    window.lines.push_back(a);
  }
}

/// Of the three rows of the neighbours those that earlier passes have finished anything of.
void CandidatePixelExtractor::open_window() {
  Window& window = window_[open_++ % windows];
  window.span = walk_.span();
  window.lines.clear();
  window.issued = window.answered = 0;
  const std::uint32_t y = window.span.y;
  if (pass_.compares_columns()) want_row(window, y - pass_.h);
  if (pass_.compares_rows()) want_row(window, y);
  if (pass_.compares_columns() && y + pass_.h < registers_.descriptor.height) want_row(window, y + pass_.h);
  if (open_ - first_ == 1) x_ = window.span.begin;
  walk_.next();
  ++spans_;
}

Neighbour CandidatePixelExtractor::neighbour(std::int64_t x, std::int64_t y) const {
  const FrameDescriptor& frame = registers_.descriptor;
  if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) return {};
  const std::uint64_t index = static_cast<std::uint64_t>(y) * frame.pitch + static_cast<std::uint64_t>(x);
  const std::uint8_t* bytes = &image_.at<std::uint8_t>(frame.frame_buffer + index * 4);
  const auto hit_class = static_cast<HitClass>(image_.at<std::uint8_t>(frame.hit_classes + index));
  return {true, hit_class, {bytes[0], bytes[1], bytes[2]}};
}

Candidate CandidatePixelExtractor::candidate(std::uint32_t x, std::uint32_t y) const {
  Candidate c;
  c.x = static_cast<std::uint16_t>(x);
  c.y = static_cast<std::uint16_t>(y);
  c.h = static_cast<std::uint8_t>(pass_.h);
  c.kind = pass_.kind;
  c.pass = number_;
  const unsigned finished = pass_.finished_neighbours();
  const std::int64_t h = pass_.h;
  for (std::size_t i = 0; i < c.ring.size(); ++i) {
    if ((finished >> i & 1) == 0) continue;
    const auto place = static_cast<std::int64_t>(i < 4 ? i : i + 1);  // of 3 x 3
    c.ring[i] = neighbour(x + (place % 3 - 1) * h, y + (place / 3 - 1) * h);
  }
  const auto compare = [&c](std::size_t first, std::size_t second) {
    if (!c.ring[first].finished || !c.ring[second].finished) return false;
    c.pairs.color[c.pairs.count++] = {c.ring[first].color, c.ring[second].color};
    return true;
  };
  const bool complete = (!pass_.compares_rows() || compare(3, 4)) && (!pass_.compares_columns() || compare(1, 6));
  if (!complete) c.pairs = {};
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
    number_ = command_->front().pass;
    command_->pop();
    const FrameDescriptor& frame = registers_.descriptor;
    pass_ = plan_.pass(number_);
    walk_ = plan_.walk(number_, frame.width, frame.height, config_.tile);
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
  return "pass " + std::to_string(number_) + ", " + std::to_string(open_ - first_) + " spans open, " +
         std::to_string(candidates_) + " candidates handed on";
}

}  // namespace artu::hw
