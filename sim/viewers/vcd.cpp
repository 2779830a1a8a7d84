#include "sim/viewers/vcd.h"

#include <algorithm>

#include "hw/fabric/phase.h"

namespace artu::sim {

namespace {

constexpr unsigned state_width = 3, phase_width = 3;

/// Characters 33 to 126, the shortest names first.
std::string identifier(std::size_t number) {
  std::string name;
  for (++number; number != 0; number /= 94) name += static_cast<char>(33 + --number % 94);
  return name;
}

unsigned width_of(std::uint32_t value) {
  unsigned width = 1;
  while (value >> width != 0) ++width;
  return width;
}

/// Picoseconds, rounded down.
std::uint64_t time_of(hw::Tick tick, const hw::ActivityLayout& layout) {
  const std::uint64_t ticks_in_a_microsecond = std::uint64_t{layout.clock_mhz} * layout.unit_period;
  return tick / ticks_in_a_microsecond * 1000000 + tick % ticks_in_a_microsecond * 1000000 / ticks_in_a_microsecond;
}

}  // namespace

void VcdTrace::declare(const std::string& path, const std::string& name, std::size_t number, unsigned width) {
  Scope* scope = &root_;
  for (std::size_t at = 0; at < path.size();) {
    const std::size_t dot = std::min(path.find('.', at), path.size());
    scope = &scope->inner[path.substr(at, dot - at)];
    at = dot + 1;
  }
  scope->variables += "$var wire " + std::to_string(width) + " " + identifier(number) + " " + name +
                      (width == 1 ? "" : " [" + std::to_string(width - 1) + ":0]") + " $end\n";
}

void VcdTrace::print(const Scope& scope, std::string& text) {
  text += scope.variables;
  for (const auto& [name, inner] : scope.inner) {
    text += "$scope module " + name + " $end\n";
    print(inner, text);
    text += "$upscope $end\n";
  }
}

void VcdTrace::begin(const hw::ActivityLayout& layout, hw::Tick tick) {
  layout_ = layout;
  begin_ = tick;
  timed_ = false;
  root_ = {};
  widths_.clear();
  std::string codes;
  for (std::size_t s = 0; s < hw::state_count; ++s) {
    codes += " " + std::to_string(s) + " = " + hw::state_name(static_cast<hw::State>(s));
  }
  codes += "; phase:";
  for (const unsigned phase :
       {hw::phase_start, hw::phase_build, hw::phase_first, hw::phase_selective, hw::phase_flush}) {
    codes += " " + std::to_string(__builtin_ctz(phase)) + " = " + hw::phase_name(phase);
  }
  text_ = "$version artu $end\n$comment state:" + codes + " $end\n$timescale 1 ps $end\n";
  first_ = 1 + layout_.blocks.size() + layout_.channels.size();
  declare("unit", "phase", 0, phase_width);
  std::size_t number = 1;
  for (const auto& block : layout_.blocks) declare("unit." + block.path, "state", number++, state_width);
  for (const auto& channel : layout_.channels) {
    widths_.push_back(width_of(channel.capacity));
    declare("unit." + channel.name, "level", number++, widths_.back());
  }
  print(root_, text_);
  text_ += "$enddefinitions $end\n";
  write(text_);
  text_.clear();
}

void VcdTrace::change(hw::Tick tick, std::size_t number, std::uint64_t value, unsigned width) {
  const std::uint64_t time = time_of(tick, layout_);
  if (!timed_ || time != time_) {
    write(text_);
    text_ = "#" + std::to_string(time) + "\n";
    if (!timed_) text_ += "$dumpvars\n";
    time_ = time;
    timed_ = true;
  }
  if (width == 1) {
    text_ += value != 0 ? '1' : '0';
  } else {
    text_ += 'b';
    unsigned bit = width_of(static_cast<std::uint32_t>(value));  // leading zeros are understood
    while (bit-- != 0) text_ += (value >> bit & 1) != 0 ? '1' : '0';
    text_ += ' ';
  }
  text_ += identifier(number) + "\n";
  if (first_ != 0 && --first_ == 0) text_ += "$end\n";
}

void VcdTrace::phase(hw::Tick tick, unsigned phase) {
  change(tick, 0, static_cast<std::uint64_t>(__builtin_ctz(phase)), phase_width);
}

void VcdTrace::state(hw::Tick tick, std::size_t block, hw::State state) {
  change(tick, 1 + block, static_cast<std::uint64_t>(state), state_width);
}

void VcdTrace::level(hw::Tick tick, std::size_t channel, std::uint32_t entries) {
  change(tick, 1 + layout_.blocks.size() + channel, entries, widths_[channel]);
}

void VcdTrace::end(hw::Tick tick) {
  const std::uint64_t time = time_of(tick, layout_);
  if (!timed_ || time != time_) text_ += "#" + std::to_string(time) + "\n";
  write(text_);
  text_.clear();
  covers(begin_, tick, layout_.unit_period);
}

}  // namespace artu::sim
