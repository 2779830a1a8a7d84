// The requests of one direction that wait in a DRAM channel, kept by bank so that the scheduler looks at banks and
// not at requests: in a bank all requests for the open row are ready at one time, and so are all others.
#pragma once

#include <cstdint>
#include <vector>

#include "hw/fabric/memory_port.h"

namespace artu::hw {

enum class RowFound : std::uint8_t { open, none, other };  // in a request's bank, when its turn came

struct DramRequest {
  MemoryResponse response;
  std::uint32_t bank = 0;
  Address line = 0;
  std::uint64_t row = 0;
  Cycle arrived = 0;
  std::uint64_t number = 0;  // in order of arrival
  RowFound found = RowFound::open;
};

class DramQueue {
 public:
  using Index = std::uint32_t;
  static constexpr Index none = ~Index{0};

  /// At most 64 banks.
  explicit DramQueue(std::uint32_t banks) : first_(banks), last_(banks), hit_(banks) { clear(); }
  void clear();

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  DramRequest& operator[](Index i) { return entries_[i].request; }
  const DramRequest& operator[](Index i) const { return entries_[i].request; }
  /// The oldest of all.
  Index oldest() const { return oldest_; }
  /// The oldest of a bank.
  Index oldest_of(std::uint32_t bank) const { return first_[bank]; }
  /// The oldest of a bank for its open row.
  Index hit_of(std::uint32_t bank) const { return hit_[bank]; }
  /// A bit for each bank with requests.
  std::uint64_t banks() const { return banks_; }
  bool holds(const DramRequest& request) const;

  /// `open`: whether the row that it asks for is open in its bank.
  void push(const DramRequest& request, bool open);
  void remove(Index i);
  void opened(std::uint32_t bank, std::uint64_t row);
  void closed(std::uint32_t bank) { hit_[bank] = none; }

 private:
  struct Entry {
    DramRequest request;
    Index older, newer;        // of all
    Index older_in, newer_in;  // of the bank; `newer_in` also links what is free
  };
  Index next_hit(Index from, std::uint64_t row) const;

  std::vector<Entry> entries_;
  Index free_ = none, oldest_ = none, newest_ = none;
  std::vector<Index> first_, last_, hit_;
  std::uint64_t banks_ = 0, numbers_ = 0;
  std::size_t size_ = 0;
};

}  // namespace artu::hw
