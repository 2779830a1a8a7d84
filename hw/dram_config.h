// Parameters of the DRAM and its controllers, and presets of published parts.
#pragma once

#include <cstdint>

#include "hw/fabric/parameter.h"

namespace artu::hw {

enum class DramPreset : std::uint8_t { lpddr4_3200, lpddr4x_4266, lpddr5_6400 };
/// Which bits of a line's number choose what, from the highest to the lowest.
enum class DramMapping : std::uint8_t { row_bank_column_channel, row_column_bank_channel, row_bank_channel_column };
enum class RowPolicy : std::uint8_t { open, closed, timeout };
enum class RefreshPolicy : std::uint8_t { none, all_bank, per_bank };

/// Times are in DRAM clocks, of which each carries two transfers.
struct DramConfig {
  /// LPDDR4-3200.
  DramConfig();

  // The part: `apply` sets all of it.
  DramPreset preset{};
  std::uint32_t clock_mhz{}, bus_bits{}, burst_length{}, banks{}, bank_groups{}, row_bytes{};
  std::uint32_t t_command{}, t_rcd{}, t_rp{}, t_rp_all{}, t_ras{}, t_cl{}, t_cwl{}, t_ccd_l{};
  std::uint32_t t_rrd{}, t_faw{}, t_rtp{}, t_wr{}, t_wtr_s{}, t_wtr_l{}, t_turn{};
  std::uint32_t t_refi{}, t_rfc{}, t_rfc_bank{};

  // Channels and controller.
  std::uint32_t channels = 2;
  std::uint32_t queue_depth = 32, write_queue_depth = 32, write_high = 24, write_low = 8;
  std::uint32_t starvation = 2000;
  DramMapping mapping = DramMapping::row_bank_column_channel;
  bool bank_hash = true;
  RowPolicy row_policy = RowPolicy::open;
  std::uint32_t row_timeout = 400;
  RefreshPolicy refresh = RefreshPolicy::all_bank;

  void visit(ParameterVisitor& v);
};

/// Gives `config` a part's organisation and timing; channels and controller stay as they are.
void apply(DramPreset preset, DramConfig& config);

}  // namespace artu::hw
