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

/// Times are in DRAM clocks, of which each carries two transfers.  The defaults are LPDDR4-3200 of 8 Gb a channel.
struct DramConfig {
  DramPreset preset = DramPreset::lpddr4_3200;
  std::uint32_t channels = 2, clock_mhz = 1600, bus_bits = 16, burst_length = 16;
  std::uint32_t banks = 8, bank_groups = 1, row_bytes = 2048;

  // Controller.
  std::uint32_t queue_depth = 32, write_queue_depth = 32, write_high = 24, write_low = 8;
  std::uint32_t starvation = 2000;
  DramMapping mapping = DramMapping::row_bank_column_channel;
  bool bank_hash = true;
  RowPolicy row_policy = RowPolicy::open;
  std::uint32_t row_timeout = 400;
  RefreshPolicy refresh = RefreshPolicy::all_bank;

  // Timing.
  std::uint32_t t_command = 4, t_rcd = 29, t_rp = 29, t_rp_all = 34, t_ras = 68, t_cl = 28, t_cwl = 14, t_ccd_l = 8;
  std::uint32_t t_rrd = 16, t_faw = 64, t_rtp = 12, t_wr = 29, t_wtr_s = 16, t_wtr_l = 16, t_turn = 2;
  std::uint32_t t_refi = 6247, t_rfc = 448, t_rfc_bank = 224;

  void visit(ParameterVisitor& v);
};

/// Gives `config` a part's organisation and timing; channels and controller stay as they are.
void apply(DramPreset preset, DramConfig& config);

}  // namespace artu::hw
