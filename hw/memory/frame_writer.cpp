#include "hw/memory/frame_writer.h"

#include <algorithm>

#include "hw/selective/candidate.h"

namespace artu::hw {

FrameWriter::FrameWriter(sc_core::sc_module_name name, ClockDomain& domain, const SelectiveConfig& selective,
                         const FrameRegisters& registers, MemoryImage& image, std::uint32_t entries)
    : Block(name, domain),
      plan_(selective),
      tile_(selective.tile),
      registers_(registers),
      image_(image),
      colors_(plan_, 4),
      classes_(plan_, 1),
      lines_(entries) {}

FrameWriter::Grid::Grid(const PassPlan& plan, std::uint32_t bytes) : bytes_a_pixel(bytes), of_pass(plan.passes()) {
  const std::uint64_t pixel = (std::uint64_t{1} << bytes) - 1;
  for (std::uint32_t number = 0; number < plan.passes(); ++number) {
    const Pass pass = plan.pass(number);
    for (std::uint32_t x = pass.x0; x * bytes < line_bytes; x += pass.dx) of_pass[number] |= pixel << (x * bytes);
  }
}

void FrameWriter::flag_sources() {
  waiting_.assign(sources_.size() / 64 + 1, 0);
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    sources_[i]->flag(waiting_[i / 64], static_cast<unsigned>(i % 64));
  }
}

void FrameWriter::reset() {
  lines_.reset();
  arbiter_.reset();
  pass_size_ = {};
  seen_ = pixels_ = line_writes_ = sampling_left_ = 0;
  sampling_told_ = true;
  unacknowledged_ = 0;
  active_ = false;
  under_way_.assign(visible_ == nullptr ? 0 : most_writes, {});
  free_tags_.clear();
  for (std::uint32_t tag = 0; tag < under_way_.size(); ++tag) free_tags_.push_back(tag);
}

bool FrameWriter::evict(Entry& entry) {
  if (visible_ != nullptr && free_tags_.empty()) return false;
  if (!memory_->request.can_push()) return false;
  std::uint32_t tag = 0;
  if (visible_ != nullptr) {
    tag = free_tags_.back();
    free_tags_.pop_back();
    under_way_[tag] = {entry.line, entry.announced};
  }
  memory_->request.push({entry.line, entry.bytes, tag, 0});
  lines_.release(entry);
  evicted_ = true;
  ++unacknowledged_;
  ++line_writes_;
  return true;
}

/// The memory has a line: with overlap those who read it are told.
bool FrameWriter::acknowledge() {
  if (visible_ != nullptr) {
    const std::uint32_t tag = memory_->response.front().tag;
    if (under_way_[tag].bytes != 0) {
      if (!visible_->can_push()) return false;
      visible_->push(under_way_[tag]);
    }
    free_tags_.push_back(tag);
  }
  memory_->response.pop();
  --unacknowledged_;
  return true;
}

/// Whether the line has an entry, or can get one; the oldest entry goes where none is free.
bool FrameWriter::reserve(Address line) { return lines_.place_for(line) != nullptr || evict(lines_.oldest()); }

std::uint32_t FrameWriter::last_pass() const {
  const FrameDescriptor& frame = registers_.descriptor;
  std::uint32_t pass = plan_.passes() - 1;
  while (pass != 0 && plan_.walk(pass, frame.width, frame.height, tile_).done()) --pass;
  return pass;
}

/// Bytes in the line of all pixels of the pixel's pass that are in its row and tile as well.
std::uint64_t FrameWriter::expected_in(const PixelToken& pixel, std::uint32_t pass, const Grid& grid) const {
  const std::uint32_t pixels = static_cast<std::uint32_t>(line_bytes) / grid.bytes_a_pixel;
  const std::uint32_t line_begin = pixel.x / pixels * pixels, tile_begin = pixel.x / tile_ * tile_;
  const std::uint32_t begin = std::max(line_begin, tile_begin);
  const std::uint32_t end = std::min({line_begin + pixels, tile_begin + tile_, registers_.descriptor.width});
  // From 1 to 64 bytes.
  const std::uint64_t span = ~std::uint64_t{0} >> (line_bytes - (end - begin) * grid.bytes_a_pixel);
  return (grid.of_pass[pass] & span) << ((begin - line_begin) * grid.bytes_a_pixel);
}

/// With overlap: which bytes are to be told of, and whether the line is complete.
void FrameWriter::note(const PixelToken& pixel, std::uint32_t pass, Entry& entry, std::uint64_t bytes,
                       const Grid& grid) {
  if (pass != last_pass_) entry.announced |= bytes;
  const std::uint64_t expected = expected_in(pixel, pass, grid);
  if ((entry.bytes & expected) == expected) lines_.complete(entry);
}

/// Puts the pixel into the entries of its two lines; false if there is no room.
bool FrameWriter::combine(const PixelToken& pixel, Address color, Address hit_class, Cycle now) {
  const Address color_line = line_of(color), class_line = line_of(hit_class);
  const std::uint64_t color_bytes = std::uint64_t{0xf} << (color - color_line);
  const std::uint64_t class_bytes = std::uint64_t{1} << (hit_class - class_line);
  if (visible_ == nullptr) {
    // Without room for the class the colour stays combined; writing it again in the next cycle changes nothing.
    if (!reserve(color_line)) return false;
    lines_.combine(color_line, color_bytes, now, 0);
    if (!reserve(class_line)) return false;
    lines_.combine(class_line, class_bytes, now, 1);
    return true;
  }
  // Each is told of once: both or none.
  while (lines_.missing(color_line, class_line) != 0) {
    if (!evict(lines_.oldest_but(color_line, class_line))) return false;
  }
  const std::uint32_t pass = plan_.pass_of(pixel.x, pixel.y);
  note(pixel, pass, lines_.combine(color_line, color_bytes, now, 0), color_bytes, colors_);
  note(pixel, pass, lines_.combine(class_line, class_bytes, now, 1), class_bytes, classes_);
  if (pass == 0 && sampling_left_ != 0) --sampling_left_;
  return true;
}

bool FrameWriter::write(const PixelToken& pixel, Cycle now) {
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint64_t index = std::uint64_t{pixel.y} * frame.pitch + pixel.x;
  const Address color = frame.frame_buffer + index * 4;
  const Address hit_class = frame.hit_classes + index;
  if (!combine(pixel, color, hit_class, now)) return false;
  store_pixel(frame, image_, pixel.x, pixel.y, {pixel.r, pixel.g, pixel.b}, pixel.hit_class);
  if (records_ != nullptr) {
    PixelRecord& record = (*records_)[std::size_t{pixel.y} * frame.width + pixel.x];
    record.r = pixel.r;
    record.g = pixel.g;
    record.b = pixel.b;
    record.hit_class = pixel.hit_class;
    // The dispatcher left the cycle in which it handed the pixel on; the difference is right modulo 2^32.
    if (pixel.hit_class != HitClass::none) record.cycles = static_cast<std::uint32_t>(now) - record.cycles;
    if (record.written < 255) ++record.written;
  }
  return true;
}

Activity FrameWriter::tick(Cycle now) {
  bool moved = memory_->response.can_pop() && acknowledge(), blocked = false;
  evicted_ = false;
  if (!active_ && pass_->can_pop()) {
    pass_size_ = pass_->front();
    pass_->pop();
    seen_ = 0;
    sampling_left_ = pass_size_.sampling;
    sampling_told_ = sampling_left_ == 0;
    last_pass_ = last_pass();
    active_ = true;
    moved = true;
  }
  const std::size_t chosen =
      arbiter_.pick(waiting_, sources_.size(), [&](std::size_t i) { return sources_[i]->can_pop(); });
  const bool all_seen = active_ && seen_ == pass_size_.pixels;
  if (chosen != sources_.size()) {
    if (write(sources_[chosen]->front(), now)) {
      sources_[chosen]->pop();
      arbiter_.granted(chosen, sources_.size());
      ++seen_;
      ++pixels_;
      moved = true;
    } else {
      blocked = true;
    }
  } else if (all_seen) {
    // End of the pass: everything goes out, one line a cycle.
    if (Entry* entry = lines_.any()) {
      (evict(*entry) ? moved : blocked) = true;
    } else if (unacknowledged_ == 0 && sampling_told_ && done_->can_push()) {
      done_->push(pass_size_);
      active_ = false;
      moved = true;
    }
  }
  Cycle next = never;
  if (visible_ != nullptr) {
    moved |= tell_sampling();
    moved |= send_due(now, blocked);
  }
  if (moved) return {State::busy, now + 1};
  if (visible_ != nullptr) next = next_due(now);
  if (blocked || (unacknowledged_ != 0 && active_ && seen_ == pass_size_.pixels)) return {State::stall_mem, next};
  return {State::stall_in, next};
}

/// The last sampling pixel is there.
bool FrameWriter::tell_sampling() {
  if (sampling_told_ || sampling_left_ != 0 || !done_->can_push()) return false;
  done_->push({pass_size_.sampling});
  sampling_told_ = true;
  return true;
}

/// An entry that need not wait any longer goes, where none has gone in this cycle.
bool FrameWriter::send_due(Cycle now, bool& blocked) {
  if (evicted_) return false;
  Entry* entry = lines_.due(now < patience ? 0 : now - patience + 1);
  if (entry == nullptr) return false;
  if (evict(*entry)) return true;
  blocked = true;
  return false;
}

/// When an entry will be one that need not wait any longer.
Cycle FrameWriter::next_due(Cycle now) const {
  const Cycle first = lines_.first_touched();
  return first != never && first + patience > now ? first + patience : never;
}

void FrameWriter::report(Statistics& out) const {
  out.push_back({path(), "pixels", pixels_, "pixels", "pixels written"});
  out.push_back({path(), "line_writes", line_writes_, "lines", "write requests, after combining"});
}

std::string FrameWriter::describe() const {
  return std::to_string(seen_) + " of " + std::to_string(pass_size_.pixels) + " pixels of the pass, " +
         std::to_string(unacknowledged_) + " writes unacknowledged";
}

}  // namespace artu::hw
