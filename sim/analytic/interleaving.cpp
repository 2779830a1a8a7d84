#include "sim/analytic/interleaving.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace artu::sim {

Interleaving::Interleaving(const hw::UnitConfig& config, std::uint32_t width, MemoryModel& memory)
    : config_(config),
      memory_(memory),
      columns_((width + config.selective.tile - 1) / config.selective.tile),
      free_(config.core.count, std::vector<std::uint64_t>(config.core.contexts, 0)),
      held_cycles_(config.core.count, 0),
      held_(buckets) {}

std::uint32_t Interleaving::core_for(std::uint32_t x, std::uint32_t y) const {
  if (config_.core.dispatch == hw::Dispatch::tiles) {
    return (y / config_.selective.tile * columns_ + x / config_.selective.tile) % config_.core.count;
  }
  // The first one after the last that has a context at the earliest time there is.
  std::uint32_t best = core_;
  std::uint64_t at = ~std::uint64_t{0};
  for (std::uint32_t i = 1; i <= config_.core.count; ++i) {
    const std::uint32_t core = core_ + i < config_.core.count ? core_ + i : core_ + i - config_.core.count;
    const std::uint64_t free = std::max(free_[core].front(), dispatched_);
    if (free >= at) continue;
    at = free;
    best = core;
  }
  return best;
}

void Interleaving::begin_pixel(std::uint32_t x, std::uint32_t y) {
  core_ = core_for(x, y);
  std::vector<std::uint64_t>& free = free_[core_];
  std::pop_heap(free.begin(), free.end(), std::greater<>());
  now_ = began_ = std::max(free.back(), dispatched_);
  dispatched_ = began_ + 1;
  pass_until(began_ >> width_shift);
}

void Interleaving::end_pixel() {
  std::vector<std::uint64_t>& free = free_[core_];
  free.back() = now_;
  std::push_heap(free.begin(), free.end(), std::greater<>());
  held_cycles_[core_] += now_ - began_;
  end_ = std::max(end_, now_);
}

void Interleaving::pass_until(std::uint64_t bucket) {
  for (; passed_ < bucket; ++passed_) {
    std::vector<Request>& requests = held_[passed_ & (buckets - 1)];
    for (const Request& r : requests) {
      if (r.client() == Client::writer || r.client() == Client::line_writer) {
        memory_.write(r.client(), r.line(), r.client() == Client::line_writer, passed_ << width_shift);
      } else {
        memory_.read(r.client(), r.core(), r.line(), passed_ << width_shift);
      }
    }
    requests.clear();
  }
}

void Interleaving::drain() {
  pass_until((end_ >> width_shift) + 1);
  dispatched_ = std::max(dispatched_, end_);
}

double Interleaving::imbalance() const {
  const std::uint64_t sum = std::accumulate(held_cycles_.begin(), held_cycles_.end(), std::uint64_t{0});
  if (sum == 0 || config_.core.dispatch != hw::Dispatch::tiles) return 1;
  const std::uint64_t most = *std::max_element(held_cycles_.begin(), held_cycles_.end());
  return static_cast<double>(most) * static_cast<double>(held_cycles_.size()) / static_cast<double>(sum);
}

}  // namespace artu::sim
