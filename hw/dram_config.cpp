#include "hw/dram_config.h"

#include <cmath>

namespace artu::hw {

DramConfig::DramConfig() { apply(DramPreset::lpddr4_3200, *this); }

void DramConfig::visit(ParameterVisitor& v) {
  v.choice("preset", preset, {"lpddr4-3200", "lpddr4x-4266", "lpddr5-6400"},
           "part whose organisation and timing are taken; parameters given with it or later change single ones");
  v.integer("channels", channels, {1, 16, true}, "", "channels");
  v.integer("clock_mhz", clock_mhz, {100, 10000}, "MHz", "clock; data moves on both edges");
  v.integer("bus_bits", bus_bits, {8, 128, true}, "bits", "data width of a channel");
  v.integer("burst_length", burst_length, {2, 64, true}, "", "transfers of a burst");
  v.integer("banks", banks, {1, 64, true}, "", "banks of a channel");
  v.integer("bank_groups", bank_groups, {1, 16, true}, "", "bank groups of a channel; at most banks");
  v.integer("row_bytes", row_bytes, {256, 65536, true}, "bytes", "row buffer of a bank");

  v.integer("queue_depth", queue_depth, {1, 256}, "", "reads that wait at a channel");
  v.integer("write_queue_depth", write_queue_depth, {1, 256}, "", "writes that wait at a channel");
  v.integer("write_high", write_high, {1, 256}, "", "waiting writes at which a channel turns to them");
  v.integer("write_low", write_low, {0, 255}, "", "waiting writes at which it turns back, if there are reads");
  v.integer("starvation", starvation, {1, 1000000}, "DRAM clocks",
            "a request that has waited so long is served before any other; 1: first come, first served");
  v.choice("mapping", mapping, {"row-bank-column-channel", "row-column-bank-channel", "row-bank-channel-column"},
           "what the bits of a line's number choose, from the highest to the lowest");
  v.flag("bank_hash", bank_hash, "bank bits are xored with the lowest row bits, so that streams do not meet in a bank");
  v.choice("row_policy", row_policy, {"open", "closed", "timeout"},
           "a row stays open, is closed after its last waiting access, or after row_timeout without one");
  v.integer("row_timeout", row_timeout, {1, 1000000}, "DRAM clocks", "of row_policy timeout");
  v.choice("refresh", refresh, {"none", "all-bank", "per-bank"}, "banks refreshed together or in turn");

  v.integer("t_command", t_command, {1, 64}, "DRAM clocks", "command bus, for a command");
  v.integer("t_rcd", t_rcd, {1, 1000}, "DRAM clocks", "activate to column command");
  v.integer("t_rp", t_rp, {1, 1000}, "DRAM clocks", "precharge of a bank to its activate");
  v.integer("t_rp_all", t_rp_all, {1, 1000}, "DRAM clocks", "precharge of all banks to refresh");
  v.integer("t_ras", t_ras, {1, 1000}, "DRAM clocks", "activate to precharge");
  v.integer("t_cl", t_cl, {1, 1000}, "DRAM clocks", "read command to first data");
  v.integer("t_cwl", t_cwl, {1, 1000}, "DRAM clocks", "write command to first data");
  v.integer("t_ccd_l", t_ccd_l, {1, 1000}, "DRAM clocks", "column commands to the same bank group");
  v.integer("t_rrd", t_rrd, {1, 1000}, "DRAM clocks", "activate to activate of another bank");
  v.integer("t_faw", t_faw, {1, 10000}, "DRAM clocks", "window of four activates");
  v.integer("t_rtp", t_rtp, {1, 1000}, "DRAM clocks", "read command to precharge");
  v.integer("t_wr", t_wr, {1, 1000}, "DRAM clocks", "end of a write's data to precharge");
  v.integer("t_wtr_s", t_wtr_s, {1, 1000}, "DRAM clocks", "end of a write's data to a read of another bank group");
  v.integer("t_wtr_l", t_wtr_l, {1, 1000}, "DRAM clocks", "end of a write's data to a read of its bank group");
  v.integer("t_turn", t_turn, {0, 1000}, "DRAM clocks", "idle data bus between a read's and a write's data");
  v.integer("t_refi", t_refi, {100, 10000000}, "DRAM clocks", "mean time from refresh to refresh of all banks");
  v.integer("t_rfc", t_rfc, {1, 100000}, "DRAM clocks", "refresh of all banks");
  v.integer("t_rfc_bank", t_rfc_bank, {1, 100000}, "DRAM clocks", "refresh of a bank");
}

namespace {

/// Nanoseconds to clocks, never too few.
std::uint32_t clocks(double nanoseconds, std::uint32_t mhz) {
  return static_cast<std::uint32_t>(std::ceil(nanoseconds * mhz / 1000 - 1e-9));
}

/// What JESD209-4 gives in nanoseconds for every speed, for 8 Gb a channel (16 Gb dual-channel dies).
void lpddr4(std::uint32_t mhz, DramConfig& c) {
  c.clock_mhz = mhz;
  c.bus_bits = 16;
  c.burst_length = 16;
  c.banks = 8;
  c.bank_groups = 1;
  c.row_bytes = 2048;
  c.t_command = 4;  // activate and column commands are two commands of two clocks each
  c.t_rcd = clocks(18, mhz);
  c.t_rp = clocks(18, mhz);
  c.t_rp_all = clocks(21, mhz);
  c.t_ras = clocks(42, mhz);
  c.t_ccd_l = 8;
  c.t_faw = clocks(mhz > 1600 ? 30 : 40, mhz);
  c.t_rrd = clocks(mhz > 1600 ? 7.5 : 10, mhz);
  c.t_rtp = clocks(7.5, mhz);
  c.t_wr = clocks(18, mhz);
  c.t_wtr_s = c.t_wtr_l = clocks(10, mhz);
  c.t_turn = 2;
  c.t_refi = clocks(3904, mhz);
  c.t_rfc = clocks(280, mhz);
  c.t_rfc_bank = clocks(140, mhz);
}

}  // namespace

void apply(DramPreset preset, DramConfig& c) {
  c.preset = preset;
  switch (preset) {
    case DramPreset::lpddr4_3200:
      lpddr4(1600, c);
      c.t_cl = 28;
      c.t_cwl = 14;
      return;
    case DramPreset::lpddr4x_4266:
      lpddr4(2133, c);
      c.t_cl = 36;
      c.t_cwl = 18;
      return;
    case DramPreset::lpddr5_6400:
      break;
  }
  // JESD209-5, 6400 Mb/s in bank-group mode: clocks of the command clock (800 MHz), four of the data clock each.
  constexpr std::uint32_t ck = 4;
  c.clock_mhz = 3200;
  c.bus_bits = 16;
  c.burst_length = 16;
  c.banks = 16;
  c.bank_groups = 4;
  c.row_bytes = 2048;
  c.t_command = 1 * ck;
  c.t_rcd = 15 * ck;
  c.t_rp = 15 * ck;
  c.t_rp_all = 17 * ck;
  c.t_ras = 34 * ck;
  c.t_cl = 20 * ck;
  c.t_cwl = 11 * ck;
  c.t_ccd_l = 4 * ck;
  c.t_rrd = 4 * ck;
  c.t_faw = 16 * ck;
  c.t_rtp = 4 * ck;
  c.t_wr = 28 * ck;
  c.t_wtr_s = 5 * ck;
  c.t_wtr_l = 10 * ck;
  c.t_turn = 2 * ck;
  c.t_refi = clocks(3906, 3200);
  c.t_rfc = clocks(210, 3200);
  c.t_rfc_bank = clocks(120, 3200);
}

}  // namespace artu::hw
