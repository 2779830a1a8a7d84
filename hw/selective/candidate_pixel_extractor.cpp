#include "hw/selective/candidate_pixel_extractor.h"

namespace artu::hw {

void CandidatePixelExtractor::reset() {
  lanes_.clear();
  first_ = open_ = fetching_ = 0;
  candidates_ = spans_ = 0;
}

void CandidatePixelExtractor::begin(const PassCommand& command) {
  const FrameDescriptor& frame = registers_.descriptor;
  for (std::uint32_t number = std::max(command.pass, command.last); number >= command.pass; --number) {
    const TileWalk walk = plan_.walk(number, frame.width, frame.height, config_.tile);
    if (!walk.done()) lanes_.push_back({number, plan_.pass(number), walk, never});
  }
  if (finished_ != nullptr) scoreboard_.begin(frame);
  // The pass before has written the frame buffer: what the cache holds of it is old.
  pixel_cache_.invalidate();
}

/// What the lane's next span and its neighbours cover.
Area CandidatePixelExtractor::looked_at(const Lane& lane) const {
  const FrameDescriptor& frame = registers_.descriptor;
  const TileWalk::Span span = lane.walk.span();
  const std::uint32_t h = lane.pass.h, above = lane.pass.compares_columns() ? h : 0;
  const std::uint32_t last = span.end - 1 - (span.end - 1 - span.begin) % lane.pass.dx;
  return {span.begin - std::min(span.begin, h), std::min(last + h, frame.width - 1), span.y - above,
          span.y + above < frame.height ? span.y + above : span.y};
}

/// The latest pass that can open a span; null if there is none.
CandidatePixelExtractor::Lane* CandidatePixelExtractor::next_lane() {
  for (Lane& lane : lanes_) {
    if (finished_ == nullptr) return &lane;
    if (lane.blocked_at == scoreboard_.version()) continue;
    if (scoreboard_.finished_before(lane.number, looked_at(lane))) return &lane;
    lane.blocked_at = scoreboard_.version();
  }
  return nullptr;
}

/// The lines of a row that hold what is looked at.
void CandidatePixelExtractor::want_row(Window& window, std::uint32_t left, std::uint32_t right, std::uint32_t y) {
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint64_t row = std::uint64_t{y} * frame.pitch;
  for (Address a = line_of(frame.frame_buffer + (row + left) * 4); a <= frame.frame_buffer + (row + right) * 4;
       a += line_bytes) {
    window.lines.push_back(a);
  }
  for (Address a = line_of(frame.hit_classes + row + left); a <= frame.hit_classes + row + right; a += line_bytes) {
    window.lines.push_back(a);
  }
}

/// Of the three rows of the neighbours those that earlier passes have finished anything of.
void CandidatePixelExtractor::open_window(Lane& lane) {
  Window& window = window_[open_++ % windows];
  const Area area = looked_at(lane);
  window.number = lane.number;
  window.pass = lane.pass;
  window.span = lane.walk.span();
  window.lines.clear();
  window.issued = window.answered = 0;
  const std::uint32_t y = window.span.y;
  if (lane.pass.compares_columns()) want_row(window, area.left, area.right, area.top);
  if (lane.pass.compares_rows()) want_row(window, area.left, area.right, y);
  if (area.bottom > y) want_row(window, area.left, area.right, area.bottom);
  if (open_ - first_ == 1) x_ = window.span.begin;
  ++spans_;
  lane.walk.next();
  lane.blocked_at = never;
  if (lane.walk.done()) lanes_.erase(lanes_.begin() + (&lane - lanes_.data()));
}

Activity CandidatePixelExtractor::tick(Cycle now) {
  bool moved = false, blocked_mem = false, blocked_out = false;
  if (memory_->response.can_pop()) {
    // The tag is the window's number in the ring.
    ++window_[memory_->response.front().tag].answered;
    memory_->response.pop();
    moved = true;
  }
  if (finished_ != nullptr && finished_->can_pop()) {
    scoreboard_.count(finished_->front());
    finished_->pop();
    moved = true;
  }
  if (lanes_.empty() && command_->can_pop()) {
    begin(command_->front());
    command_->pop();
    moved = true;
  }
  if (open_ - first_ < windows) {
    if (Lane* lane = next_lane()) {
      open_window(*lane);
      moved = true;
    }
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
      out_->push(candidate_at(registers_.descriptor, image_, window.pass, window.number, x_, window.span.y));
      ++candidates_;
      moved = true;
      x_ += window.pass.dx;
      if (x_ >= window.span.end) {
        ++first_;
        if (first_ != open_) x_ = window_[first_ % windows].span.begin;
      }
    }
  }
  if (moved) return {State::busy, now + 1};
  if (blocked_out) return {State::stall_out};
  if (blocked_mem) return {State::stall_mem};
  return {State::stall_in};
}

void CandidatePixelExtractor::report(Statistics& out) const {
  out.push_back({path(), "candidates", candidates_, "pixels", "candidate pixels handed on"});
  out.push_back({path(), "spans", spans_, "", "rows of tiles whose lines were fetched"});
  if (finished_ != nullptr) {
    out.push_back(
        {path(), "max_scoreboard_bytes", scoreboard_.bytes(), "bytes", "counters of finished pixels, one a tile"});
  }
}

std::string CandidatePixelExtractor::describe() const {
  std::string text = "passes";
  for (const Lane& lane : lanes_) text += " " + std::to_string(lane.number);
  return (lanes_.empty() ? "no pass" : text) + " to open, " + std::to_string(open_ - first_) + " spans open, " +
         std::to_string(candidates_) + " candidates handed on";
}

}  // namespace artu::hw
