#include "hw/memory/frame_writer.h"

#include <algorithm>

namespace artu::hw {

FrameWriter::FrameWriter(sc_core::sc_module_name name, ClockDomain& domain, const FrameRegisters& registers,
                         MemoryImage& image, std::uint32_t entries)
    : Block(name, domain), registers_(registers), image_(image), entries_(entries) {}

void FrameWriter::flag_sources() {
  waiting_.assign(sources_.size() / 64 + 1, 0);
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    sources_[i]->flag(waiting_[i / 64], static_cast<unsigned>(i % 64));
  }
}

void FrameWriter::reset() {
  std::fill(entries_.begin(), entries_.end(), Entry{});
  arbiter_.reset();
  clock_ = expected_ = seen_ = pixels_ = line_writes_ = 0;
  unacknowledged_ = 0;
  active_ = false;
}

bool FrameWriter::evict(Entry& entry) {
  if (!memory_->request.can_push()) return false;
  memory_->request.push({entry.line, entry.bytes, 0, 0});
  entry.bytes = 0;
  ++unacknowledged_;
  ++line_writes_;
  return true;
}

/// Whether the line has an entry, or gets one; the oldest entry goes where none is free.
bool FrameWriter::reserve(Address line) {
  Entry* place = nullptr;
  for (Entry& entry : entries_) {
    if (entry.bytes != 0 && entry.line == line) return true;
    if (entry.bytes == 0) place = &entry;
  }
  if (place == nullptr) {
    place = &*std::min_element(entries_.begin(), entries_.end(),
                               [](const Entry& a, const Entry& b) { return a.age < b.age; });
    if (!evict(*place)) return false;
  }
  return true;
}

void FrameWriter::combine(Address address, std::uint64_t bytes) {
  const Address line = line_of(address);
  const std::uint64_t mask = bytes << (address - line);
  Entry* free = nullptr;
  for (Entry& entry : entries_) {
    if (entry.bytes != 0 && entry.line == line) {
      entry.bytes |= mask;
      return;
    }
    if (entry.bytes == 0) free = &entry;
  }
  *free = {line, mask, ++clock_};
}

bool FrameWriter::write(const PixelToken& pixel, Cycle now) {
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint64_t index = std::uint64_t{pixel.y} * frame.pitch + pixel.x;
  const Address color = frame.frame_buffer + index * 4;
  const Address hit_class = frame.hit_classes + index;
  if (!reserve(line_of(color))) return false;
  combine(color, 0xf);
  if (!reserve(line_of(hit_class))) {
    // The colour stays combined; writing it again in the next cycle changes nothing.
    return false;
  }
  combine(hit_class, 0x1);
  std::uint8_t* bytes = &image_.at<std::uint8_t>(color);
  bytes[0] = pixel.r;
  bytes[1] = pixel.g;
  bytes[2] = pixel.b;
  bytes[3] = 255;
  image_.at<std::uint8_t>(hit_class) = static_cast<std::uint8_t>(pixel.hit_class);
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
  bool moved = false, blocked = false;
  if (memory_->response.can_pop()) {
    memory_->response.pop();
    --unacknowledged_;
    moved = true;
  }
  if (!active_ && pass_->can_pop()) {
    expected_ = pass_->front().pixels;
    pass_->pop();
    seen_ = 0;
    active_ = true;
    moved = true;
  }
  const std::size_t chosen =
      arbiter_.pick(waiting_, sources_.size(), [&](std::size_t i) { return sources_[i]->can_pop(); });
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
  } else if (active_ && seen_ == expected_) {
    // End of the pass: everything goes out, one line a cycle.
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [](const Entry& e) { return e.bytes != 0; });
    if (entry != entries_.end()) {
      if (evict(*entry)) {
        moved = true;
      } else {
        blocked = true;
      }
    } else if (unacknowledged_ == 0 && done_->can_push()) {
      done_->push({expected_});
      active_ = false;
      moved = true;
    }
  }
  if (moved) return {State::busy, now + 1};
  if (blocked || (unacknowledged_ != 0 && active_ && seen_ == expected_)) return {State::stall_mem};
  return {State::stall_in};
}

void FrameWriter::report(Statistics& out) const {
  out.push_back({path(), "pixels", pixels_, "pixels", "pixels written"});
  out.push_back({path(), "line_writes", line_writes_, "lines", "write requests, after combining"});
}

std::string FrameWriter::describe() const {
  return std::to_string(seen_) + " of " + std::to_string(expected_) + " pixels of the pass, " +
         std::to_string(unacknowledged_) + " writes unacknowledged";
}

}  // namespace artu::hw
