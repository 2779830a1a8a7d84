// The unit's memory without time: which of the requests of a frame miss in the L1 caches, the L2 and the DRAM's rows.
#pragma once

#include <array>

#include "hw/datapath/pixel_rays.h"
#include "hw/unit_config.h"
#include "sim/analytic/sampled_cache.h"

namespace artu::sim {

/// Who asks.
enum class Client : std::uint8_t { node, triangle, texture, pixel, writer, line_writer, builder };
inline constexpr std::size_t clients = 7;

/// Of the sampled lines alone; times sample_factor for all.
struct MemoryCounts {
  struct OfClient {
    std::uint64_t requests = 0, misses = 0, merged = 0;  // of its L1; `misses` without `merged`: lines fetched
  };
  std::array<OfClient, clients> client;
  std::uint64_t l2_reads = 0, l2_writes = 0, l2_fills = 0, l2_merged = 0, l2_write_backs = 0;
  std::uint64_t l2_unfetched = 0;  // writes of whole lines that were not there
  std::uint64_t row_misses = 0;    // of the L2's fills and write-backs

  MemoryCounts& operator-=(const MemoryCounts& other);
};

class MemoryModel {
 public:
  explicit MemoryModel(const hw::UnitConfig& config);

  /// A sampled line, by its number.  `now` orders the requests; it says which are close enough to share a miss.
  void read(Client client, std::uint32_t core, std::uint64_t line, std::uint64_t now);
  /// Straight to the L2; of the frame writer, the pixel cache forgets it.  A
  /// write of a `whole` line fetches nothing.
  void write(Client client, std::uint64_t line, bool whole, std::uint64_t now);

  const MemoryCounts& counts() const { return counts_; }
  std::uint64_t dirty_lines() const { return l2_.dirty_lines(); }

 private:
  void below(std::uint64_t line, bool write, bool whole, std::uint64_t now, std::uint64_t latency);
  void dram(std::uint64_t line);

  const hw::UnitConfig& config_;
  std::array<std::vector<SampledCache>, 3> l1_;  // nodes, triangles, textures; by core
  SampledCache pixel_, l2_;
  std::vector<std::uint64_t> open_rows_;  // by channel and bank
  MemoryCounts counts_;
};

}  // namespace artu::sim
