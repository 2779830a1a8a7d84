#include "sim/command/ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>
#include <utility>

#include "sim/report/names.h"
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

/// Whether it is an integer without a sign, be it too large for any number here.
bool is_integer(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// At least one item; "a,,b" has an empty one.
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> items;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    items.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return items;
}

}  // namespace

std::optional<FrameRange> parse_frames(const std::string& text) {
  if (text == "all") return std::nullopt;
  const std::size_t colon = text.find(':');
  const std::string from = text.substr(0, colon), to = colon == std::string::npos ? from : text.substr(colon + 1);
  const auto first = parse_number(from);
  auto last = parse_number(to);
  constexpr std::uint32_t end = std::numeric_limits<std::uint32_t>::max();  // behind every frame
  if (is_integer(from) && is_integer(to) && (first.value_or(end) == end || !last)) {
    throw InputError("--frames", fmt::format("{} is out of range; frames of 0 ... {} would be right", text, end - 1));
  }
  if (last && colon == std::string::npos) ++*last;
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

void check_fps(double fps) {
  if (fps > 0 && fps <= 1e6) return;
  throw InputError("--fps", fmt::format("{} is out of range; above 0, up to 1000000, would be right", fps));
}

PictureSize parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const std::string x = text.substr(0, cross), y = cross == std::string::npos ? "" : text.substr(cross + 1);
  const auto width = parse_number(x), height = parse_number(y);
  if (!is_integer(x) || !is_integer(y)) {
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

std::vector<hw::PrecisionConfig> parse_formats(const std::string& text) {
  std::vector<hw::PrecisionConfig> formats;
  for (const std::string& item : split(text, ',')) {
    const std::vector<std::string> range = split(item, '-'), parts = split(item, '/');
    std::vector<std::uint32_t> bits;
    for (const std::string& part : range.size() > 1 ? range : parts) {
      const auto m = parse_number<std::uint32_t>(part);
      if (m && *m >= 7 && *m <= 23) bits.push_back(*m);
    }
    if (range.size() == 2 && bits.size() == 2 && bits[0] <= bits[1]) {
      for (std::uint32_t m = bits[0]; m <= bits[1]; ++m) formats.push_back({m, m, m});
    } else if (range.size() == 1 && bits.size() == parts.size() && bits.size() <= 3) {
      const bool same = bits.size() == 1;
      formats.push_back({bits[0], same ? bits[0] : bits[1], same ? bits[0] : bits.size() == 3 ? bits[2] : 23});
    } else {
      throw InputError("--bits", fmt::format("\"{}\" is no width; M, M-N or BOX/TRIANGLE[/SHADING] with 7 to 23 bits "
                                             "each, such as 7-23, 10/23 or 12/15/10, would be right",
                                             item));
    }
  }
  return formats;
}

std::vector<hw::TreeKind> parse_trees(const std::string& text) {
  std::vector<hw::TreeKind> trees;
  for (const std::string& item : split(text, ',')) {
    const auto* known = std::find_if(std::begin(all_trees), std::end(all_trees),
                                     [&](hw::TreeKind kind) { return item == tree_name(kind); });
    if (known == std::end(all_trees)) {
      throw InputError("--trees", fmt::format("\"{}\" is no tree; bvh2, bvh4, bvh8 and kd, with commas between them, "
                                              "would be right",
                                              item));
    }
    trees.push_back(*known);
  }
  return trees;
}

PictureSet parse_pictures(const std::string& text) {
  PictureSet set;
  if (text == "none") return set;
  for (const std::string& item : split(text, ',')) {
    const auto* known = std::find(std::begin(picture_names), std::end(picture_names), item);
    if (item == "none") {
      throw InputError("--pictures",
                       fmt::format("none stands alone, and \"{}\" has more; none, or the others without it, would be "
                                   "right",
                                   text));
    }
    if (item != "all" && known == std::end(picture_names)) {
      std::string names;
      for (const char* name : picture_names) names += std::string(name) + ", ";
      throw InputError(
          "--pictures",
          fmt::format("\"{}\" is no picture; of {}with commas between them, all or none would be right", item, names));
    }
    for (std::size_t i = 0; i < picture_count; ++i) {
      if (item == "all" || item == picture_names[i]) set.add(static_cast<Picture>(i));
    }
  }
  return set;
}

std::vector<std::uint32_t> parse_references(const std::string& text) {
  std::vector<std::uint32_t> references;
  for (const std::string& item : split(text, ',')) {
    const auto reference = parse_number(item);
    if (!reference || *reference > 255) {
      throw InputError("--references", fmt::format("\"{}\" is no threshold; 0 ... 255, with commas between them, such "
                                                   "as 4,8,16, would be right",
                                                   item));
    }
    if (std::find(references.begin(), references.end(), *reference) == references.end()) {
      references.push_back(*reference);
    }
  }
  return references;
}

std::vector<double> parse_shares(const std::string& text) {
  std::vector<double> shares;
  for (const std::string& item : split(text, ',')) {
    const auto percent = parse_number<double>(item);
    if (!percent || !(*percent > 0 && *percent <= 100)) {
      throw InputError("--shares", fmt::format("\"{}\" is no percentage above 0 and up to 100; such as 30,40,50 would "
                                               "be right",
                                               item));
    }
    shares.push_back(*percent / 100);
  }
  return shares;
}

MemoryTraceFormat parse_memory_trace_format(const std::string& text) {
  static constexpr std::pair<const char*, MemoryTraceFormat> formats[] = {
      {"dramsim3", MemoryTraceFormat::dramsim3},
      {"ramulator", MemoryTraceFormat::ramulator},
      {"ramulator2", MemoryTraceFormat::ramulator2}};
  for (const auto& [name, format] : formats) {
    if (text == name) return format;
  }
  throw InputError("--memory-trace-format",
                   fmt::format("\"{}\" is no format; dramsim3, ramulator or ramulator2 would be right", text));
}

TraceRequest parse_trace(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string kind = text.substr(0, equals);
  for (const TraceKind known : trace_kinds) {
    if (kind != trace_kind_name(known)) continue;
    if (equals == std::string::npos) return {known, ""};
    if (equals + 1 < text.size()) return {known, text.substr(equals + 1)};
    throw InputError("--trace", fmt::format("\"{}\" names no file; {} or {}=FILE would be right", text, kind, kind));
  }
  std::string names;
  for (const TraceKind known : trace_kinds) {
    names += fmt::format("{}{}",
                         names.empty()                 ? ""
                         : known == trace_kinds.back() ? " or "
                                                       : ", ",
                         trace_kind_name(known));
  }
  throw InputError("--trace",
                   fmt::format("\"{}\" is no kind of trace; {}, and =FILE after it, would be right", kind, names));
}

hw::Cycle parse_cycle(const std::string& option, const std::string& text) {
  if (const auto cycle = parse_number<std::uint64_t>(text)) return *cycle;
  throw InputError(option, fmt::format("\"{}\" is no cycle; an integer from 0 to 2^64 - 1 would be right", text));
}

double parse_percent(const std::string& option, const std::string& text) {
  if (!text.empty() && text.back() == '%') {
    const auto percent = parse_number<double>(text.substr(0, text.size() - 1));
    if (percent && *percent > 0 && *percent <= 100) return *percent / 100;
  }
  throw InputError(option,
                   fmt::format("\"{}\" is not a share; a percentage such as 5%, above 0% and at most 100%, would be "
                               "right",
                               text));
}

std::uint64_t parse_seed(const std::string& text) {
  if (const auto seed = parse_number<std::uint64_t>(text)) return *seed;
  throw InputError("--seed", fmt::format("\"{}\" is not a seed; an integer from 0 to 2^64 - 1 would be right", text));
}

}  // namespace artu::sim
