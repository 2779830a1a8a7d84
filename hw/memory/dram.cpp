#include "hw/memory/dram.h"

#include <algorithm>

namespace artu::hw {

Dram::Dram(sc_core::sc_module_name name, ClockDomain& domain, const DramConfig& config)
    : MainMemory(name, domain),
      config_(config),
      channels_(config.channels, DramChannel(config)),
      step_at_(config.channels, never) {}

void Dram::reset() {
  for (DramChannel& channel : channels_) channel.reset();
  std::fill(step_at_.begin(), step_at_.end(), never);
  arbiter_.reset();
  placed_ = false;
  answers_ = 0;
  read_bytes_ = write_bytes_ = 0;
}

/// One answer a clock.
bool Dram::answer(Cycle now, bool& blocked) {
  if (next_answer() > now) return false;
  if (!link_->response.can_push()) {
    blocked = true;
    return false;
  }
  const std::size_t chosen =
      arbiter_.pick(channels_.size(), [&](std::size_t i) { return channels_[i].has_answer(now); });
  DramChannel& channel = channels_[chosen];
  if (answers_++ != lost_) link_->response.push(channel.front());
  channel.pop();
  arbiter_.granted(chosen, channels_.size());
  return true;
}

Cycle Dram::next_answer() const {
  Cycle at = never;
  for (const DramChannel& channel : channels_) at = std::min(at, channel.next_answer());
  return at;
}

bool Dram::can_accept() {
  if (!link_->request.can_pop()) return false;
  const MemoryRequest& request = link_->request.front();
  if (!placed_) {
    place_ = place_of_line(config_, request.line / line_bytes);
    placed_ = true;
  }
  return channels_[place_.channel].can_accept(request.write());
}

bool Dram::accept(Cycle now) {
  if (!can_accept()) return false;
  const MemoryRequest& request = link_->request.front();
  channels_[place_.channel].accept(request, place_, now);
  if (observer_) observer_(now, request);
  step_at_[place_.channel] = now;
  (request.write() ? write_bytes_ : read_bytes_) += line_bytes;
  link_->request.pop();
  placed_ = false;
  return true;
}

Activity Dram::tick(Cycle now) {
  bool blocked = false;
  bool moved = answer(now, blocked);
  moved = accept(now) || moved;
  Cycle next = never;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (step_at_[i] <= now) step_at_[i] = channels_[i].step(now);
    next = std::min(next, step_at_[i]);
    // An answer that is blocked waits for room, not for a clock.
    if (!blocked || !channels_[i].has_answer(now)) next = std::min(next, channels_[i].next_answer());
  }
  if (can_accept()) next = now + 1;
  if (next != never) {
    Activity activity(blocked && !moved ? State::stall_out : State::busy, std::max(next, now + 1));
    if (blocked) activity.after = State::stall_out;  // until there is room, whatever else moved in this cycle
    return activity;
  }
  if (blocked) return {State::stall_out};
  return moved ? Activity::once(State::busy, State::stall_in) : Activity(State::stall_in);
}

void Dram::report(Statistics& out) const {
  const std::string block = path();
  DramChannel::Counts sum;
  for (const DramChannel& channel : channels_) {
    const DramChannel::Counts& c = channel.counts();
    sum.row_hits += c.row_hits;
    sum.row_misses += c.row_misses;
    sum.row_empty += c.row_empty;
    sum.bus_clocks += c.bus_clocks;
    sum.refreshes += c.refreshes;
    sum.turns += c.turns;
    sum.forwarded += c.forwarded;
    sum.activates += c.activates;
    sum.precharges += c.precharges;
    sum.reads += c.reads;
    sum.writes += c.writes;
    sum.read_clocks += c.read_clocks;
  }
  out.push_back({block, "read_bytes", read_bytes_, "bytes", "read from DRAM, or from a waiting write"});
  out.push_back({block, "write_bytes", write_bytes_, "bytes", "written to DRAM"});
  out.push_back({block, "reads", sum.reads, "lines", "read in the banks"});
  out.push_back({block, "writes", sum.writes, "lines", "written in the banks"});
  out.push_back({block, "row_hits", sum.row_hits, "", "accesses to an open row"});
  out.push_back({block, "row_misses", sum.row_misses, "", "accesses to a bank with another row open"});
  out.push_back({block, "row_empty", sum.row_empty, "", "accesses to a bank without an open row"});
  out.push_back({block, "forwarded", sum.forwarded, "", "reads answered by a waiting write of the line"});
  out.push_back({block, "bus_clocks", sum.bus_clocks, "DRAM clocks", "data buses occupied, all channels"});
  out.push_back(
      {block, "read_clocks", sum.read_clocks, "DRAM clocks", "from taking a read to its last data, all reads"});
  out.push_back({block, "activates", sum.activates, "", "rows opened"});
  out.push_back({block, "precharges", sum.precharges, "", "rows closed, by refreshes too"});
  out.push_back({block, "refreshes", sum.refreshes, "", "refresh commands that a later access met"});
  out.push_back({block, "turns", sum.turns, "", "changes between reading and writing"});
}

std::string Dram::describe() const {
  std::string text;
  for (const DramChannel& channel : channels_) {
    text += (text.empty() ? "" : ", ") + std::to_string(channel.waiting()) + " requests in flight";
  }
  return text;
}

}  // namespace artu::hw
