// The order in which a unit's cores ask for lines, from pixels that are known one after another.
//
// Every pixel begins when a context of its core is free and asks for its lines as if nothing ever missed; requests are
// held back in buckets of a few cycles until no pixel can begin before them.
#pragma once

#include "sim/analytic/memory_model.h"

namespace artu::sim {

class Interleaving {
 public:
  Interleaving(const hw::UnitConfig& config, std::uint32_t width, MemoryModel& memory);

  /// Chooses core and context for the pixel, and lets requests pass that are certainly earlier than all of it.
  void begin_pixel(std::uint32_t x, std::uint32_t y);
  /// The pixel goes on for so long.
  void advance(std::uint32_t cycles) { now_ += cycles; }
  void read(Client client, std::uint64_t line) { hold({line, core_, client}, now_); }
  void end_pixel();
  /// By the frame writer and for the candidates, beside the pixels' own requests.
  void read_pixels(std::uint64_t line) { hold({line, 0, Client::pixel}, dispatched_); }
  void write_pixels(Client writer, std::uint64_t line) { hold({line, 0, writer}, dispatched_); }
  /// A candidate that no core sees; they come one a cycle.
  void pass_candidate() { ++dispatched_; }
  /// Everything that is held back; pixels of the next pass begin after it.
  void drain();

  /// When the last context became free, as if nothing ever missed.
  std::uint64_t end() const { return end_; }
  /// Where tiles choose the core: cycles that the busiest core's contexts were held, over the mean of all cores.  1
  /// where cores take turns.
  double imbalance() const;

 private:
  struct Request {
    Request(std::uint64_t line, std::uint32_t core, Client client)
        : packed(line << 16 | std::uint64_t{core} << 8 | static_cast<std::uint64_t>(client)) {}
    std::uint64_t line() const { return packed >> 16; }
    std::uint32_t core() const { return static_cast<std::uint32_t>(packed >> 8 & 255); }
    Client client() const { return static_cast<Client>(packed & 255); }
    std::uint64_t packed;  // many are held: one word each
  };
  static constexpr std::uint64_t width_shift = 3, buckets = 8192;

  void hold(const Request& request, std::uint64_t at) {
    // What lies further ahead than there are buckets comes a little early.
    const std::uint64_t bucket = std::min(at >> width_shift, passed_ + buckets - 1);
    held_[bucket & (buckets - 1)].push_back(request);
  }
  void pass_until(std::uint64_t bucket);
  std::uint32_t core_for(std::uint32_t x, std::uint32_t y) const;

  const hw::UnitConfig& config_;
  MemoryModel& memory_;
  const std::uint32_t columns_;                   // of tiles
  std::vector<std::vector<std::uint64_t>> free_;  // by core: when its contexts are free, as a heap
  std::vector<std::uint64_t> held_cycles_;        // by core
  std::vector<std::vector<Request>> held_;
  std::uint64_t passed_ = 0;  // bucket before which all requests have passed
  std::uint64_t now_ = 0, began_ = 0, dispatched_ = 0, end_ = 0;
  std::uint32_t core_ = 0;
};

}  // namespace artu::sim
