// A trace for waveform viewers: a value change dump (docs/viewers.md), with a variable for the state of every block and
// one for the level of every channel.  Time is real, in picoseconds.
// Source: IEEE 1364-2005, clause 18.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/viewers/trace_writer.h"

namespace artu::sim {

class VcdTrace : public TraceWriter {
 public:
  using TraceWriter::TraceWriter;

  void begin(const hw::ActivityLayout& layout, hw::Tick tick) override;
  void phase(hw::Tick tick, unsigned phase) override;
  void state(hw::Tick tick, std::size_t block, hw::State state) override;
  void level(hw::Tick tick, std::size_t channel, std::uint32_t entries) override;
  void end(hw::Tick tick) override;

 private:
  struct Scope {
    std::map<std::string, Scope> inner;
    std::string variables;  // their declarations
  };
  void declare(const std::string& path, const std::string& name, std::size_t number, unsigned width);
  static void print(const Scope& scope, std::string& text);
  void change(hw::Tick tick, std::size_t number, std::uint64_t value, unsigned width);

  hw::ActivityLayout layout_;
  Scope root_;
  std::vector<unsigned> widths_;  // of the levels
  hw::Tick begin_ = 0;
  std::uint64_t time_ = 0;
  bool timed_ = false;     // a time has been written
  std::size_t first_ = 0;  // values still to be told at the beginning
  std::string text_;
};

}  // namespace artu::sim
