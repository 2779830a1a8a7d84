// Set-associative cache with MSHRs, write-back, write-allocate; L1s and L2 alike.
//
// In:  one request channel a client, served round-robin, one request a cycle; lines from below, one a cycle.
// Out: one response a cycle; requests to below.
// Latency: `hit_latency` from a request's arrival to its response (the response channel's latency).
// Hit under miss: a miss waits in an MSHR while later requests go on; a second miss on the same line waits in
// the same MSHR.  Stalls a client whose miss finds no MSHR (stall_mem) or whose response channel is full (stall_out).
// A free way first, then what `replacement` says; with `hashed` the set is a hash of the line's address.  A write of a
// whole line allocates without a fetch.
#pragma once

#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/fabric/round_robin.h"
#include "hw/memory/replacement.h"
#include "hw/unit_config.h"

namespace artu::hw {

struct CacheCommand {};

/// Bytes of a line that another block has written below.
struct LineWritten {
  Address line = 0;
  std::uint64_t bytes = 0;
};

class Cache : public Block {
 public:
  /// No more fills and write-backs are outstanding than `below` has room for responses, so that the memory below can
  /// always answer; twice `mshrs` is enough not to hold anything up.  A bank of several gets every `banks`-th line (a
  /// power of two); `config` is its own share.
  Cache(sc_core::sc_module_name name, ClockDomain& domain, const CacheConfig& config, std::uint32_t banks = 1);

  /// Ports.
  void add_client(MemoryLink& link) {
    clients_.push_back(&link);
    blocked_at_.push_back(never);
  }
  void bind_below(MemoryLink& link) { below_ = &link; }
  /// Optional: a command writes all dirty lines back, `flushed` answers when the memory below has them.
  void bind_flush(Fifo<CacheCommand>& flush, Fifo<CacheCommand>& flushed) {
    flush_ = &flush;
    flushed_ = &flushed;
  }

  /// Optional: a line that was written below is forgotten, one a cycle, and then handed on: who gets it from there may
  /// ask for the line again.  One that is on its way is answered to those who wait for it, and not kept.
  void bind_written(Fifo<LineWritten>& written, Fifo<LineWritten>& forgotten) {
    written_ = &written;
    forgotten_ = &forgotten;
  }

  /// Forgets all lines (none may be dirty); for a client that knows that memory has changed.
  void invalidate();

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;

  std::uint64_t fills() const { return fills_; }
  std::uint64_t write_backs() const { return write_backs_; }
  std::uint64_t hits() const { return hits_; }
  std::uint64_t misses() const { return misses_; }
  bool quiet() const { return busy_mshrs_ == 0 && outstanding_writes_ == 0; }

 private:
  /// A line's address, and in its lowest bit whether it is dirty; 0 = none (address 0 is never used).
  class Line {
   public:
    Line() = default;
    Line(Address address, bool dirty) : word_(address | (dirty ? 1 : 0)) {}
    bool empty() const { return word_ == 0; }
    Address address() const { return word_ & ~Address{1}; }
    bool dirty() const { return (word_ & 1) != 0; }
    void set_dirty() { word_ |= 1; }
    void clean() { word_ &= ~Address{1}; }

   private:
    Address word_ = 0;
  };
  struct Target {
    std::uint32_t tag;
    std::uint16_t source, client;
  };
  struct Mshr {
    bool filled = false, dirty = false;
    bool stale = false;  // written below after it was asked for
    std::uint32_t answered = 0;
    std::vector<Target> targets;
  };

  Activity tick(Cycle now) override;
  bool forget_written();
  bool accept_fill();
  bool answer_target();
  bool serve(std::size_t client, bool& blocked_out);
  bool miss(std::size_t client, const MemoryRequest& request);
  bool flush();
  bool flush_step();
  bool anything_left() const;
  std::size_t set_of(Address line) const;
  std::uint32_t way_of(std::size_t set, Address line) const;
  bool install(Address line, bool dirty);
  std::size_t mshr_of(Address line) const;

  const CacheConfig config_;
  const std::size_t sets_;                 // a power of two
  const unsigned line_shift_, set_shift_;  // of an address to the number of its line in the bank; of that
  std::vector<MemoryLink*> clients_;
  MemoryLink* below_ = nullptr;
  Fifo<CacheCommand>* flush_ = nullptr;
  Fifo<CacheCommand>* flushed_ = nullptr;
  Fifo<LineWritten>* written_ = nullptr;
  Fifo<LineWritten>* forgotten_ = nullptr;

  std::vector<Line> lines_;  // sets_ times ways
  Replacement replacement_;
  std::vector<Mshr> mshrs_;
  std::vector<Address> mshr_lines_;    // line of each MSHR, 0 = free: apart, since every miss looks through all
  std::vector<std::uint32_t> filled_;  // MSHRs with targets to answer, in order of their fills
  std::size_t filled_head_ = 0;
  std::uint32_t busy_mshrs_ = 0;
  RoundRobin arbiter_;
  // A miss that found no MSHR need not be looked at again before the MSHRs or the lines have changed.
  std::uint64_t changes_ = 0;
  std::vector<std::uint64_t> blocked_at_;  // by client: the value of changes_ when its miss was turned away
  bool flushing_ = false;
  std::size_t flush_at_ = 0;
  std::uint32_t outstanding_writes_ = 0;
  std::uint64_t hits_ = 0, misses_ = 0, merged_ = 0, fills_ = 0, write_backs_ = 0, reads_ = 0, writes_ = 0;
  std::uint64_t invalidations_ = 0;
};

}  // namespace artu::hw
