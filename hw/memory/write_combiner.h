// The lines that the frame writer holds back to be filled up: content-addressed, one entry a line.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "hw/fabric/memory_port.h"

namespace artu::hw {

class WriteCombiner {
 public:
  struct Entry {
    Address line = 0;
    std::uint64_t bytes = 0;      // 0: free
    std::uint64_t announced = 0;  // of them those that a later pass reads
    std::uint64_t age = 0;
    Cycle touched = 0;
    bool complete = false;  // nothing more is to be expected soon
  };

  explicit WriteCombiner(std::uint32_t entries) : entries_(entries) { reset(); }
  void reset() {
    std::fill(entries_.begin(), entries_.end(), Entry{});
    clock_ = 0;
    last_ = {&entries_[0], &entries_[0]};
    complete_ = 0;
    touched_from_ = never;
  }

  /// The entry of a line, or a free one; null if there is neither.
  Entry* place_for(Address line) {
    for (Entry* entry : last_) {
      if (entry->bytes != 0 && entry->line == line) return entry;
    }
    Entry* place = nullptr;
    for (Entry& entry : entries_) {
      if (entry.bytes != 0 && entry.line == line) return &entry;
      if (entry.bytes == 0) place = &entry;
    }
    return place;
  }
  /// Of a full buffer.
  Entry& oldest() {
    return *std::min_element(entries_.begin(), entries_.end(),
                             [](const Entry& a, const Entry& b) { return a.age < b.age; });
  }
  /// How many entries are missing for both lines to have one.
  std::uint32_t missing(Address a, Address b) const {
    if (last_[0]->line == a && last_[1]->line == b && last_[0]->bytes != 0 && last_[1]->bytes != 0) return 0;
    std::uint32_t missing = 2;
    for (const Entry& entry : entries_) {
      if ((entry.bytes == 0 || entry.line == a || entry.line == b) && missing != 0) --missing;
    }
    return missing;
  }
  /// The oldest that is neither's; there is one if an entry is missing.
  Entry& oldest_but(Address a, Address b) {
    Entry* found = nullptr;
    for (Entry& entry : entries_) {
      if (entry.bytes == 0 || entry.line == a || entry.line == b) continue;
      if (found == nullptr || entry.age < found->age) found = &entry;
    }
    return *found;
  }
  /// Any that is not free; null if there is none.
  Entry* any() {
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [](const Entry& e) { return e.bytes != 0; });
    return entry == entries_.end() ? nullptr : &*entry;
  }
  /// The oldest that is complete or was last touched before `since`; null if there is none.
  Entry* due(Cycle since) {
    if (complete_ == 0 && touched_from_ >= since) return nullptr;
    Entry* found = nullptr;
    touched_from_ = never;
    for (Entry& entry : entries_) {
      if (entry.bytes == 0) continue;
      touched_from_ = std::min(touched_from_, entry.touched);
      if (!entry.complete && entry.touched >= since) continue;
      if (found == nullptr || entry.age < found->age) found = &entry;
    }
    return found;
  }
  /// Of the entry that has not been touched for the longest time; `never` if all are free.
  Cycle first_touched() const {
    Cycle first = never;
    for (const Entry& entry : entries_) {
      if (entry.bytes != 0) first = std::min(first, entry.touched);
    }
    return first;
  }

  /// Adds bytes to the line's entry, or begins one.  `which` of a pixel's two lines it is: the last of each is found
  /// again without a search.
  Entry& combine(Address line, std::uint64_t bytes, Cycle now, std::size_t which) {
    Entry& entry = *place_for(line);
    if (entry.bytes == 0) entry = {line, 0, 0, ++clock_, now, false};
    entry.bytes |= bytes;
    entry.touched = now;
    touched_from_ = std::min(touched_from_, now);
    last_[which] = &entry;
    return entry;
  }
  void complete(Entry& entry) {
    if (!entry.complete) ++complete_;
    entry.complete = true;
  }
  void release(Entry& entry) {
    if (entry.complete) --complete_;
    entry.complete = false;
    entry.bytes = 0;
  }

 private:
  std::vector<Entry> entries_;
  std::array<Entry*, 2> last_{};
  std::uint64_t clock_ = 0;
  std::size_t complete_ = 0;    // entries that are
  Cycle touched_from_ = never;  // no entry was last touched before
};

}  // namespace artu::hw
