#include "hw/memory/cache.h"

#include <algorithm>

namespace artu::hw {

namespace {
constexpr std::uint32_t write_back_tag = 0xffffffffu;
constexpr std::uint64_t whole_line = ~std::uint64_t{0};
}  // namespace

Cache::Cache(sc_core::sc_module_name name, ClockDomain& domain, const CacheConfig& config, std::uint32_t banks)
    : Block(name, domain),
      config_(config),
      sets_(config.size / line_bytes / config.ways),
      line_shift_(static_cast<unsigned>(__builtin_ctzll(line_bytes * banks))),
      set_shift_(sets_ > 1 ? static_cast<unsigned>(__builtin_ctzll(sets_)) : 1),
      replacement_(config.replacement, sets_, config.ways, config.seed) {
  lines_.resize(sets_ * config.ways);
  mshrs_.resize(config.mshrs);
  mshr_lines_.resize(config.mshrs);
  for (Mshr& mshr : mshrs_) mshr.targets.reserve(config.targets);
}

void Cache::invalidate() { std::fill(lines_.begin(), lines_.end(), Line{}); }

void Cache::reset() {
  invalidate();
  for (Mshr& mshr : mshrs_) {
    mshr.filled = mshr.dirty = mshr.stale = false;
    mshr.targets.clear();
  }
  std::fill(mshr_lines_.begin(), mshr_lines_.end(), 0);
  filled_.clear();
  filled_head_ = 0;
  busy_mshrs_ = outstanding_writes_ = 0;
  arbiter_.reset();
  changes_ = 0;
  std::fill(blocked_at_.begin(), blocked_at_.end(), never);
  replacement_.reset();
  flushing_ = false;
  hits_ = misses_ = merged_ = fills_ = write_backs_ = reads_ = writes_ = invalidations_ = 0;
}

std::size_t Cache::set_of(Address line) const {
  const std::uint64_t index = line >> line_shift_;
  return (config_.hashed ? index ^ (index >> set_shift_) ^ (index >> (2 * set_shift_)) : index) & (sets_ - 1);
}

/// The way that holds the line, or for 0 one that holds nothing; the number of ways if there is none.
std::uint32_t Cache::way_of(std::size_t set, Address line) const {
  // All ways are compared, as the hardware does: that is faster than to guess where to stop.
  const Line* ways = &lines_[set * config_.ways];
  std::uint32_t found = config_.ways;
  for (std::uint32_t way = config_.ways; way-- != 0;) found = ways[way].address() == line ? way : found;
  return found;
}

/// The MSHR of a line, or a free one for line 0; the number of MSHRs if there is none.
std::size_t Cache::mshr_of(Address line) const {
  return static_cast<std::size_t>(std::find(mshr_lines_.begin(), mshr_lines_.end(), line) - mshr_lines_.begin());
}

/// Puts a line in its set; false if the victim is dirty and cannot be written back in this cycle.
bool Cache::install(Address line, bool dirty) {
  const std::size_t set = set_of(line);
  std::uint32_t way = way_of(set, 0);
  if (way == config_.ways) way = replacement_.victim(set);
  Line& place = lines_[set * config_.ways + way];
  if (place.dirty()) {
    if (!below_->request.can_push()) return false;
    below_->request.push({place.address(), whole_line, write_back_tag, 0});
    ++outstanding_writes_;
    ++write_backs_;
  }
  if (!place.empty()) replacement_.replaced();
  place = Line(line, dirty);
  replacement_.touch(set, way);
  ++changes_;
  return true;
}

/// (0) A line that was written below, before anything is looked up in this cycle.
bool Cache::forget_written() {
  if (!forgotten_->can_push()) return false;
  const Address address = written_->front().line;
  const std::size_t set = set_of(address);
  if (const std::uint32_t way = way_of(set, address); way != config_.ways) {
    lines_[set * config_.ways + way] = {};
    ++invalidations_;
    ++changes_;
  }
  const std::size_t present = mshr_of(address);
  if (present != mshrs_.size() && !mshrs_[present].filled) mshrs_[present].stale = true;
  forgotten_->push(written_->front());
  written_->pop();
  return true;
}

/// (1) A line, or the acknowledgement of a write-back, from below.
bool Cache::accept_fill() {
  const std::uint32_t tag = below_->response.front().tag;
  if (tag == write_back_tag) {
    --outstanding_writes_;
    below_->response.pop();
    return true;
  }
  Mshr& mshr = mshrs_[tag];
  if (!mshr.stale && !install(mshr_lines_[tag], mshr.dirty)) return false;
  below_->response.pop();
  ++fills_;
  mshr.filled = true;
  mshr.answered = 0;
  filled_.push_back(tag);
  return true;
}

/// (2) One of the requests that waited for a line that is now here.
bool Cache::answer_target() {
  Mshr& mshr = mshrs_[filled_[filled_head_]];
  const Target& target = mshr.targets[mshr.answered];
  Fifo<MemoryResponse>& response = clients_[target.client]->response;
  if (!response.can_push()) return false;
  response.push({target.tag, target.source});
  if (++mshr.answered == mshr.targets.size()) {
    mshr.filled = mshr.dirty = mshr.stale = false;
    mshr.targets.clear();
    mshr_lines_[filled_[filled_head_]] = 0;
    ++changes_;
    --busy_mshrs_;
    if (++filled_head_ == filled_.size()) {
      filled_.clear();
      filled_head_ = 0;
    }
  }
  return true;
}

bool Cache::miss(std::size_t client, const MemoryRequest& request) {
  const Target target{request.tag, request.source, static_cast<std::uint16_t>(client)};
  const std::size_t present = busy_mshrs_ == 0 ? mshrs_.size() : mshr_of(request.line);
  if (present != mshrs_.size()) {
    Mshr& mshr = mshrs_[present];
    // A filled one is being emptied: its line may already be gone again, so wait for it to be free.
    if (mshr.filled || mshr.stale || mshr.targets.size() == config_.targets) {
      blocked_at_[client] = changes_;
      return false;
    }
    mshr.targets.push_back(target);
    mshr.dirty |= request.write();
    ++misses_;
    ++merged_;
    return true;
  }
  // Answers of the memory below must never wait for this cache: it may itself wait to write a victim back.
  if (busy_mshrs_ + outstanding_writes_ >= below_->response.capacity()) return false;
  if (request.bytes == whole_line) {
    Fifo<MemoryResponse>& response = clients_[client]->response;
    if (!response.can_push() || !install(request.line, true)) return false;
    response.push({request.tag, request.source});
    ++misses_;
    return true;
  }
  if (busy_mshrs_ == config_.mshrs) {
    blocked_at_[client] = changes_;
    return false;
  }
  if (!below_->request.can_push()) return false;
  const std::size_t free = mshr_of(0);
  ++changes_;
  mshr_lines_[free] = request.line;
  mshrs_[free].dirty = request.write();
  mshrs_[free].targets.push_back(target);
  ++busy_mshrs_;
  ++misses_;
  below_->request.push({request.line, 0, static_cast<std::uint32_t>(free), 0});
  return true;
}

/// (3) The next request of a client.
bool Cache::serve(std::size_t client, bool& blocked_out) {
  MemoryLink& link = *clients_[client];
  const MemoryRequest& request = link.request.front();  // there until it is popped
  const std::size_t set = set_of(request.line);
  if (const std::uint32_t way = way_of(set, request.line); way != config_.ways) {
    if (!link.response.can_push()) {
      blocked_out = true;
      return false;
    }
    replacement_.touch(set, way);
    if (request.write()) lines_[set * config_.ways + way].set_dirty();
    link.response.push({request.tag, request.source});
    ++hits_;
  } else if (!miss(client, request)) {
    return false;
  }
  ++(request.write() ? writes_ : reads_);
  link.request.pop();
  return true;
}

/// Writes back one dirty line a cycle; true while there is something to do.
bool Cache::flush_step() {
  while (flush_at_ < lines_.size() && !lines_[flush_at_].dirty()) ++flush_at_;
  if (flush_at_ < lines_.size()) {
    if (!below_->request.can_push()) return false;
    below_->request.push({lines_[flush_at_].address(), whole_line, write_back_tag, 0});
    lines_[flush_at_].clean();
    ++outstanding_writes_;
    ++write_backs_;
    return true;
  }
  if (outstanding_writes_ != 0 || !flushed_->can_push()) return false;
  flushed_->push({});
  flushing_ = false;
  return true;
}

Activity Cache::tick(Cycle now) {
  bool moved = written_ != nullptr && written_->can_pop() && forget_written();
  if (below_->response.can_pop()) moved |= accept_fill();
  bool blocked_out = false, blocked_mem = false;
  if (filled_head_ != filled_.size()) {
    if (answer_target()) {
      moved = true;
    } else {
      blocked_out = true;
    }
  } else {
    // A client whose request cannot be served does not keep the others from being served.
    const std::size_t client = arbiter_.pick(clients_.size(), [&](std::size_t i) {
      if (!clients_[i]->request.can_pop()) return false;
      if (blocked_at_[i] != changes_ && serve(i, blocked_out)) return true;
      blocked_mem = true;
      return false;
    });
    if (client != clients_.size()) {
      arbiter_.granted(client, clients_.size());
      moved = true;
    }
  }
  if (flush_ != nullptr && (flushing_ || flush_->can_pop())) moved |= flush();

  const State waiting = busy_mshrs_ != 0 || outstanding_writes_ != 0 ? State::stall_mem : State::stall_in;
  if (moved) return anything_left() ? Activity(State::busy, now + 1) : Activity::once(State::busy, waiting);
  if (blocked_out) return {State::stall_out};
  return {blocked_mem ? State::stall_mem : waiting};
}

/// Work that the next cycle could do without anything arriving.
bool Cache::anything_left() const {
  for (const MemoryLink* client : clients_) {
    if (client->request.can_pop()) return true;
  }
  return filled_head_ != filled_.size() || flushing_ || below_->response.can_pop() ||
         (written_ != nullptr && written_->can_pop());
}

/// Takes the command, then one step a cycle; true if something was done.
bool Cache::flush() {
  if (flushing_) return flush_step();
  flush_->pop();
  flushing_ = true;
  flush_at_ = 0;
  flush_step();
  return true;
}

void Cache::report(Statistics& out) const {
  const std::string block = path();
  out.push_back({block, "reads", reads_, "", "read requests served"});
  out.push_back({block, "writes", writes_, "", "write requests served"});
  out.push_back({block, "hits", hits_, "", "requests whose line was there"});
  out.push_back({block, "misses", misses_, "", "requests whose line was not there"});
  out.push_back({block, "merged_misses", merged_, "", "misses on a line that was already on its way"});
  out.push_back({block, "fills", fills_, "lines", "lines fetched from below"});
  out.push_back({block, "write_backs", write_backs_, "lines", "dirty lines written to below"});
  if (written_ != nullptr) {
    out.push_back({block, "invalidations", invalidations_, "lines", "lines forgotten since they were written below"});
  }
}

std::string Cache::describe() const {
  return std::to_string(busy_mshrs_) + " of " + std::to_string(config_.mshrs) + " lines outstanding, " +
         std::to_string(outstanding_writes_) + " write-backs unacknowledged";
}

}  // namespace artu::hw
