#include "sim/command/ranges.h"

#include <fmt/format.h>

#include <charconv>
#include <utility>

#include "traces/error.h"

namespace artu::sim {
namespace {

template <class Number = std::uint32_t>
std::optional<Number> parse_number(const std::string& text) {
  Number value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<FrameRange> parse_frames(const std::string& text) {
  if (text == "all") return std::nullopt;
  const std::size_t colon = text.find(':');
  const auto first = parse_number(text.substr(0, colon));
  const auto last = colon == std::string::npos ? std::optional<std::uint32_t>(first ? *first + 1 : 0)
                                               : parse_number(text.substr(colon + 1));
  if (!first || !last) {
    throw InputError("--frames",
                     fmt::format("\"{}\" is not a range; A:B (B is not included), A or all would be right", text));
  }
  if (*first >= *last) {
    throw InputError("--frames",
                     fmt::format("{} is empty; A:B with A below B would be right, B is not included", text));
  }
  return FrameRange{*first, *last};
}

PictureSize parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto width = parse_number(text.substr(0, cross));
  const auto height = cross == std::string::npos ? std::nullopt : parse_number(text.substr(cross + 1));
  if (!width || !height) {
    throw InputError("--size", fmt::format("\"{}\" is not a size; WIDTHxHEIGHT such as 640x360 would be right", text));
  }
  const PictureSize size{width.value_or(0), height.value_or(0)};
  for (const std::uint32_t edge : {size.width, size.height}) {
    if (edge >= 1 && edge <= 16384) continue;
    throw InputError("--size", fmt::format("{} is out of range; 1x1 ... 16384x16384 would be right", text));
  }
  return size;
}

hw::Fault parse_fault(const std::string& text) {
  static constexpr std::pair<const char*, hw::Datapath> datapaths[] = {{"box", hw::Datapath::box},
                                                                       {"triangle", hw::Datapath::triangle},
                                                                       {"shading", hw::Datapath::shading},
                                                                       {"interpolation", hw::Datapath::interpolation},
                                                                       {"threshold", hw::Datapath::threshold},
                                                                       {"dram", hw::Datapath::dram}};
  const std::size_t colon = text.find(':');
  for (const auto& [name, datapath] : datapaths) {
    if (text.substr(0, colon) != name) continue;
    if (colon == std::string::npos) return {datapath, 0};
    // Intervals and t have 32 bits, colour codes and thresholds 8.
    const bool wide =
        datapath == hw::Datapath::box || datapath == hw::Datapath::triangle || datapath == hw::Datapath::dram;
    const auto bit = parse_number<std::uint32_t>(text.substr(colon + 1));
    if (bit && *bit < (wide ? 32 : 8)) return {datapath, *bit};
    throw InputError("--inject-fault", fmt::format("\"{}\" has no such bit; {}:0 ... {}:{} would be right", text, name,
                                                   name, wide ? 31 : 7));
  }
  throw InputError("--inject-fault",
                   fmt::format("\"{}\" is not a datapath; box, triangle, shading, interpolation, threshold or "
                               "dram, with :BIT, would be right",
                               text));
}

hw::LogRule parse_log_rule(const std::string& text) {
  static constexpr std::pair<const char*, hw::LogLevel> levels[] = {
      {"off", hw::LogLevel::off}, {"info", hw::LogLevel::info}, {"debug", hw::LogLevel::debug}};
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos && equals != 0) {
    for (const auto& [name, level] : levels) {
      if (text.substr(equals + 1) == name) return {text.substr(0, equals), level};
    }
  }
  throw InputError("--log", fmt::format("\"{}\" is no rule; BLOCK=LEVEL with off, info or debug, such as "
                                        "core0.traversal=debug or *=info, would be right",
                                        text));
}

std::uint64_t parse_seed(const std::string& text) {
  if (const auto seed = parse_number<std::uint64_t>(text)) return *seed;
  throw InputError("--seed", fmt::format("\"{}\" is not a seed; an integer from 0 to 2^64 - 1 would be right", text));
}

}  // namespace artu::sim
