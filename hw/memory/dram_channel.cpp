#include "hw/memory/dram_channel.h"

#include <algorithm>

namespace artu::hw {

namespace {

unsigned log2_of(std::uint64_t power) { return static_cast<unsigned>(__builtin_ctzll(power)); }

Cycle bursts_of(const DramConfig& c) {
  const std::uint32_t bits = c.bus_bits * c.burst_length;
  return (line_bytes * 8 + bits - 1) / bits;
}

Cycle refresh_interval(const DramConfig& c) {
  return c.refresh == RefreshPolicy::per_bank ? std::max<Cycle>(c.t_refi / c.banks, 1) : c.t_refi;
}

}  // namespace

std::uint64_t bus_bytes_of_line(const DramConfig& config) {
  return bursts_of(config) * config.burst_length * config.bus_bits / 8;
}

DramPlace place_of_line(const DramConfig& config, std::uint64_t line) {
  // All counts are powers of two.
  const auto take = [&line](std::uint32_t count) {
    const auto part = static_cast<std::uint32_t>(line & (count - 1));
    line >>= log2_of(count);
    return part;
  };
  const std::uint32_t columns = config.row_bytes / line_bytes;
  DramPlace place;
  switch (config.mapping) {
    case DramMapping::row_bank_column_channel:
      place.channel = take(config.channels);
      take(columns);
      place.bank = take(config.banks);
      break;
    case DramMapping::row_column_bank_channel:
      place.channel = take(config.channels);
      place.bank = take(config.banks);
      take(columns);
      break;
    case DramMapping::row_bank_channel_column:
      take(columns);
      place.channel = take(config.channels);
      place.bank = take(config.banks);
      break;
  }
  place.row = line;
  if (config.bank_hash) place.bank ^= static_cast<std::uint32_t>(line) & (config.banks - 1);
  return place;
}

DramChannel::DramChannel(const DramConfig& config)
    : config_(config),
      data_(bursts_of(config) * (config.burst_length / 2)),
      last_column_(data_ - config.burst_length / 2),
      same_group_(std::max<Cycle>(data_, last_column_ + config.t_ccd_l)),
      reads_(config.banks),
      writes_(config.banks),
      banks_(config.banks),
      group_read_at_(config.bank_groups),
      group_write_at_(config.bank_groups) {
  reset();
}

void DramChannel::reset() {
  reads_.clear();
  writes_.clear();
  answers_.clear();
  answered_ = 0;
  std::fill(banks_.begin(), banks_.end(), Bank{});
  std::fill(group_read_at_.begin(), group_read_at_.end(), 0);
  std::fill(group_write_at_.begin(), group_write_at_.end(), 0);
  activates_.fill(0);
  activate_index_ = 0;
  writing_ = false;
  command_at_ = read_at_ = write_at_ = 0;
  refresh_at_ = config_.refresh == RefreshPolicy::none ? never : refresh_interval(config_);
  refresh_bank_ = 0;
  counts_ = {};
}

void DramChannel::answer(Cycle done, const MemoryResponse& response) {
  answers_.push_back({done, response});
  for (std::size_t i = answers_.size() - 1; i > answered_ && answers_[i].done < answers_[i - 1].done; --i) {
    std::swap(answers_[i], answers_[i - 1]);
  }
}

void DramChannel::pop() {
  if (++answered_ != answers_.size()) return;
  answers_.clear();
  answered_ = 0;
}

void DramChannel::accept(const MemoryRequest& request, const DramPlace& place, Cycle now) {
  const DramRequest waiting{{request.tag, request.source}, place.bank, request.line, place.row, now, 0, RowFound::open};
  if (!request.write() && writes_.holds(waiting)) {
    ++counts_.forwarded;
    ++counts_.read_clocks;
    answer(now + 1, waiting.response);
    return;
  }
  const Bank& bank = banks_[place.bank];
  (request.write() ? writes_ : reads_).push(waiting, bank.open && bank.row == place.row);
}

/// Refreshes that came due while nothing waited are made up for at their own times: the state is the same.
void DramChannel::refresh(Cycle now) {
  while (refresh_at_ <= now) {
    const Cycle due = refresh_at_;
    const bool all = config_.refresh == RefreshPolicy::all_bank;
    const std::uint32_t first = all ? 0 : refresh_bank_, last = all ? config_.banks : refresh_bank_ + 1;
    Cycle start = due;
    for (std::uint32_t i = first; i < last; ++i) {
      time_out(i, due);
      const Bank& bank = banks_[i];
      // An open row is closed first; one that was just closed has its precharge to end.
      const Cycle closed = std::max(due, bank.precharge_at) + (all ? config_.t_rp_all : config_.t_rp);
      start = std::max(start, bank.open ? closed : bank.activate_at);
    }
    for (std::uint32_t i = first; i < last; ++i) {
      if (banks_[i].open) ++counts_.precharges;
      close(i, start + (all ? config_.t_rfc : config_.t_rfc_bank));
    }
    refresh_bank_ = (refresh_bank_ + 1) % config_.banks;
    refresh_at_ += refresh_interval(config_);
    ++counts_.refreshes;
  }
}

void DramChannel::close(std::uint32_t bank, Cycle activate_at) {
  banks_[bank].open = false;
  banks_[bank].activate_at = activate_at;
  reads_.closed(bank);
  writes_.closed(bank);
}

void DramChannel::time_out(std::uint32_t index, Cycle now) {
  const Bank& bank = banks_[index];
  if (config_.row_policy != RowPolicy::timeout || !bank.open) return;
  const Cycle at = std::max(bank.precharge_at, bank.used_at + config_.row_timeout);
  if (at >= now) return;
  // Kept for an access that was there in time, or a short timeout would close every row before its first one.
  for (const DramQueue* queue : {&reads_, &writes_}) {
    const DramQueue::Index hit = queue->hit_of(index);
    if (hit != DramQueue::none && (*queue)[hit].arrived <= at) return;
  }
  close(index, at + config_.t_rp);
  ++counts_.precharges;
}

/// Whether the oldest of a queue goes before all others.
bool DramChannel::starves(const DramQueue& queue, Cycle now) const {
  return !queue.empty() && now >= queue[queue.oldest()].arrived + config_.starvation;
}

void DramChannel::choose_direction(Cycle now) {
  const bool before = writing_, read_starves = starves(reads_, now), write_starves = starves(writes_, now);
  if (reads_.empty() || writes_.empty()) {
    writing_ = reads_.empty();
  } else if (read_starves || write_starves) {
    writing_ = write_starves && !(read_starves && reads_[reads_.oldest()].arrived <= writes_[writes_.oldest()].arrived);
  } else if (writes_.size() >= config_.write_high) {
    writing_ = true;
  } else if (writes_.size() <= config_.write_low) {
    writing_ = false;
  }
  if (writing_ != before) ++counts_.turns;
}

/// Of a request for the open row.
Cycle DramChannel::column_at(std::uint32_t bank) const {
  const std::size_t group = bank % config_.bank_groups;
  return std::max({banks_[bank].column_at, writing_ ? write_at_ : read_at_,
                   writing_ ? group_write_at_[group] : group_read_at_[group]});
}

Cycle DramChannel::activate_at(const Bank& bank) const {
  Cycle at = bank.activate_at;
  const Cycle last = activates_[(activate_index_ + 3) % 4], fourth = activates_[activate_index_];
  if (last != 0) at = std::max(at, last - 1 + config_.t_rrd);
  if (fourth != 0) at = std::max(at, fourth - 1 + config_.t_faw);
  return at;
}

void DramChannel::precharge(std::uint32_t bank, Cycle now) {
  close(bank, now + config_.t_rp);
  ++counts_.precharges;
}

void DramChannel::activate(DramRequest& request, Cycle now) {
  Bank& bank = banks_[request.bank];
  bank.open = true;
  bank.row = request.row;
  bank.column_at = now + config_.t_rcd;
  bank.precharge_at = now + config_.t_ras;
  bank.used_at = now;
  if (request.found == RowFound::open) request.found = RowFound::none;
  reads_.opened(request.bank, request.row);
  writes_.opened(request.bank, request.row);
  activates_[activate_index_] = now + 1;
  activate_index_ = (activate_index_ + 1) % 4;
  ++counts_.activates;
}

void DramChannel::column(DramQueue& queue, DramQueue::Index index, Cycle now) {
  const DramRequest request = queue[index];
  const bool write = writing_;
  queue.remove(index);
  ++(request.found == RowFound::open   ? counts_.row_hits
     : request.found == RowFound::none ? counts_.row_empty
                                       : counts_.row_misses);
  ++(write ? counts_.writes : counts_.reads);
  Bank& bank = banks_[request.bank];
  const Cycle latency = write ? config_.t_cwl : config_.t_cl, end = now + latency + data_;
  answer(end, request.response);
  counts_.bus_clocks += data_;
  if (!write) counts_.read_clocks += end - request.arrived;
  bank.used_at = now;
  bank.precharge_at =
      std::max(bank.precharge_at, write ? end + config_.t_wr : now + last_column_ + Cycle{config_.t_rtp});
  const std::size_t group = request.bank % config_.bank_groups;
  const auto push = [](Cycle& at, Cycle earliest) { at = std::max(at, earliest); };
  if (write) {
    push(write_at_, now + data_);
    push(group_write_at_[group], now + same_group_);
    push(read_at_, end + config_.t_wtr_s);
    push(group_read_at_[group], end + config_.t_wtr_l);
  } else {
    push(read_at_, now + data_);
    push(group_read_at_[group], now + same_group_);
    // The write's data may follow the read's after the bus has turned.
    const Cycle turned = end + config_.t_turn;
    push(write_at_, turned > config_.t_cwl ? turned - config_.t_cwl : 0);
  }
  if (config_.row_policy == RowPolicy::closed && queue.hit_of(request.bank) == DramQueue::none) {
    close(request.bank, bank.precharge_at + config_.t_rp);  // with the column command: no command of its own
    ++counts_.precharges;
  }
}

/// What the bank of this request, the oldest of it or of all, could be sent, and when.
void DramChannel::consider(DramQueue::Index oldest, bool starving, Cycle now, Choice& hit, Choice& other) const {
  const DramQueue& queue = writing_ ? writes_ : reads_;
  const DramRequest& request = queue[oldest];
  const Bank& bank = banks_[request.bank];
  const DramQueue::Index open = queue.hit_of(request.bank);
  // A row with waiting accesses is not closed, except for a request that has waited for too long.
  if (open != DramQueue::none && (!starving || open == oldest)) {
    hit.consider(std::max(column_at(request.bank), now), open, queue[open].number);
  } else {
    other.consider(std::max(bank.open ? bank.precharge_at : activate_at(bank), now), oldest, request.number);
  }
}

Cycle DramChannel::step(Cycle now) {
  if (reads_.empty() && writes_.empty()) return never;
  refresh(now);
  choose_direction(now);
  DramQueue& queue = writing_ ? writes_ : reads_;
  if (config_.row_policy == RowPolicy::timeout) {
    for (std::uint64_t banks = queue.banks(); banks != 0; banks &= banks - 1) {
      time_out(static_cast<std::uint32_t>(__builtin_ctzll(banks)), now);
    }
  }
  Choice hit, other;
  if (starves(queue, now)) {
    consider(queue.oldest(), true, now, hit, other);
  } else {
    for (std::uint64_t banks = queue.banks(); banks != 0; banks &= banks - 1) {
      const auto bank = static_cast<std::uint32_t>(__builtin_ctzll(banks));
      consider(queue.oldest_of(bank), false, now, hit, other);
    }
  }
  const Cycle next = std::max(std::min(hit.at, other.at), command_at_);
  if (next > now) {
    Cycle wake = std::min(next, refresh_at_);
    for (const DramQueue* waiting : {&reads_, &writes_}) {
      if (!waiting->empty() && !starves(*waiting, now)) {
        wake = std::min(wake, (*waiting)[waiting->oldest()].arrived + config_.starvation);
      }
    }
    return std::max(wake, now + 1);
  }
  command_at_ = now + config_.t_command;
  if (hit.at <= now) {
    column(queue, hit.index, now);
  } else {
    DramRequest& request = queue[other.index];
    if (banks_[request.bank].open) {
      precharge(request.bank, now);
      request.found = RowFound::other;
    } else {
      activate(request, now);
    }
  }
  return reads_.empty() && writes_.empty() ? never : std::max(command_at_, now + 1);
}

}  // namespace artu::hw
