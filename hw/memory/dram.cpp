#include "hw/memory/dram.h"

#include <algorithm>

namespace artu::hw {

namespace {
unsigned log2_of(std::uint64_t power) { return static_cast<unsigned>(__builtin_ctzll(power)); }
}  // namespace

Dram::Dram(sc_core::sc_module_name name, ClockDomain& domain, const DramConfig& config)
    : Block(name, domain),
      config_(config),
      // Whole bursts; two transfers a clock.
      burst_((line_bytes * 8 + config.bus_bits * config.burst_length - 1) / (config.bus_bits * config.burst_length) *
             (config.burst_length / 2)),
      channel_shift_(log2_of(config.channels)),
      bank_shift_(log2_of(config.banks)),
      row_shift_(log2_of(config.row_bytes / line_bytes)),
      channels_(config.channels) {
  for (Channel_& channel : channels_) channel.banks.resize(config.banks);
}

void Dram::reset() {
  for (Channel_& channel : channels_) {
    std::fill(channel.banks.begin(), channel.banks.end(), Bank{});
    channel.bus_free = 0;
    channel.queue.clear();
    channel.head = 0;
  }
  arbiter_.reset();
  answers_ = 0;
  read_bytes_ = write_bytes_ = row_hits_ = row_misses_ = row_empty_ = bus_clocks_ = 0;
}

void Dram::accept(Channel_& channel, std::uint64_t line_index, const MemoryRequest& request, Cycle now) {
  // Line index within the channel: column, then bank, then row, so that a stream stays in open rows.
  // All three are powers of two.
  const std::uint64_t row_index = line_index >> row_shift_;
  const std::uint64_t bank_index = row_index & (config_.banks - 1);
  const std::uint64_t row = row_index >> bank_shift_;
  Bank& bank = channel.banks[bank_index];
  Cycle column = std::max<Cycle>(now, bank.column_at);
  if (bank.open && bank.row == row) {
    ++row_hits_;
  } else {
    Cycle activate = std::max(now, bank.column_at);
    if (bank.open) {
      ++row_misses_;
      activate = std::max(activate, bank.precharge_at) + config_.t_rp;
    } else {
      ++row_empty_;
    }
    bank.open = true;
    bank.row = row;
    bank.precharge_at = activate + config_.t_ras;
    column = activate + config_.t_rcd;
  }
  const Cycle data = std::max(column + config_.t_cl, channel.bus_free);
  channel.bus_free = data + burst_;
  bus_clocks_ += burst_;
  bank.column_at = data - config_.t_cl + burst_;
  channel.queue.push_back({data + burst_, {request.tag, request.source}});
  (request.write() ? write_bytes_ : read_bytes_) += line_bytes;
}

Activity Dram::tick(Cycle now) {
  bool moved = false, blocked = false;
  // One answer a clock; each channel's answers are in order.
  const auto ready = [&](std::size_t i) {
    return channels_[i].waiting() != 0 && channels_[i].queue[channels_[i].head].done <= now;
  };
  const std::size_t chosen = arbiter_.pick(channels_.size(), ready);
  if (chosen != channels_.size()) {
    if (link_->response.can_push()) {
      Channel_& channel = channels_[chosen];
      if (answers_++ != lost_) link_->response.push(channel.queue[channel.head].response);
      if (++channel.head == channel.queue.size()) {
        channel.queue.clear();
        channel.head = 0;
      }
      arbiter_.granted(chosen, channels_.size());
      moved = true;
    } else {
      blocked = true;
    }
  }
  if (link_->request.can_pop()) {
    const MemoryRequest& request = link_->request.front();
    const std::uint64_t line_index = request.line / line_bytes;
    Channel_& channel = channels_[line_index & (config_.channels - 1)];
    if (channel.waiting() < config_.queue_depth) {
      accept(channel, line_index >> channel_shift_, request, now);
      link_->request.pop();
      moved = true;
    }
  }
  if (moved && link_->request.can_pop()) return {State::busy, now + 1};
  if (blocked && !moved) return {State::stall_out};
  Cycle next = never;
  for (const Channel_& channel : channels_) {
    if (channel.waiting() != 0) next = std::min(next, channel.queue[channel.head].done);
  }
  if (next != never) return {State::busy, std::max(next, now + 1)};
  return moved ? Activity::once(State::busy, State::stall_in) : Activity(State::stall_in);
}

void Dram::report(Statistics& out) const {
  const std::string block = path();
  out.push_back({block, "read_bytes", read_bytes_, "bytes", "read from DRAM"});
  out.push_back({block, "write_bytes", write_bytes_, "bytes", "written to DRAM"});
  out.push_back({block, "row_hits", row_hits_, "", "requests to an open row"});
  out.push_back({block, "row_misses", row_misses_, "", "requests to a bank with another row open"});
  out.push_back({block, "row_empty", row_empty_, "", "requests to a bank without an open row"});
  out.push_back({block, "bus_clocks", bus_clocks_, "DRAM clocks", "data buses occupied, all channels"});
}

std::string Dram::describe() const {
  std::string text;
  for (const Channel_& channel : channels_) {
    text += (text.empty() ? "" : ", ") + std::to_string(channel.waiting()) + " requests in flight";
  }
  return text;
}

}  // namespace artu::hw
