#include "hw/memory/dram_queue.h"

#include <algorithm>

namespace artu::hw {

void DramQueue::clear() {
  entries_.clear();
  free_ = oldest_ = newest_ = none;
  for (std::vector<Index>* by_bank : {&first_, &last_, &hit_}) std::fill(by_bank->begin(), by_bank->end(), none);
  banks_ = numbers_ = 0;
  size_ = 0;
}

bool DramQueue::holds(const DramRequest& request) const {
  for (Index i = first_[request.bank]; i != none; i = entries_[i].newer_in) {
    if (entries_[i].request.line == request.line) return true;
  }
  return false;
}

void DramQueue::push(const DramRequest& request, bool open) {
  Index i = free_;
  if (i == none) {
    i = static_cast<Index>(entries_.size());
    entries_.emplace_back();
  } else {
    free_ = entries_[i].newer_in;
  }
  const std::uint32_t bank = request.bank;
  Entry& entry = entries_[i];
  entry = {request, newest_, none, last_[bank], none};
  entry.request.number = numbers_++;
  (newest_ == none ? oldest_ : entries_[newest_].newer) = i;
  (last_[bank] == none ? first_[bank] : entries_[last_[bank]].newer_in) = i;
  newest_ = last_[bank] = i;
  if (open && hit_[bank] == none) hit_[bank] = i;
  banks_ |= std::uint64_t{1} << bank;
  ++size_;
}

void DramQueue::remove(Index i) {
  Entry& entry = entries_[i];
  const std::uint32_t bank = entry.request.bank;
  if (hit_[bank] == i) hit_[bank] = next_hit(entry.newer_in, entry.request.row);
  (entry.older == none ? oldest_ : entries_[entry.older].newer) = entry.newer;
  (entry.newer == none ? newest_ : entries_[entry.newer].older) = entry.older;
  (entry.older_in == none ? first_[bank] : entries_[entry.older_in].newer_in) = entry.newer_in;
  (entry.newer_in == none ? last_[bank] : entries_[entry.newer_in].older_in) = entry.older_in;
  if (first_[bank] == none) banks_ &= ~(std::uint64_t{1} << bank);
  entry.newer_in = free_;
  free_ = i;
  --size_;
}

void DramQueue::opened(std::uint32_t bank, std::uint64_t row) { hit_[bank] = next_hit(first_[bank], row); }

/// From this one on.
DramQueue::Index DramQueue::next_hit(Index from, std::uint64_t row) const {
  while (from != none && entries_[from].request.row != row) from = entries_[from].newer_in;
  return from;
}

}  // namespace artu::hw
