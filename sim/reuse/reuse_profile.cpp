#include "sim/reuse/reuse_profile.h"

#include <algorithm>
#include <stdexcept>

namespace artu::sim {

namespace {

std::uint64_t size_of(const std::string& kind, const hw::UnitConfig& unit) {
  if (kind == "node_cache") return unit.core.node_cache.size;
  if (kind == "triangle_cache") return unit.core.triangle_cache.size;
  if (kind == "texture_cache") return unit.core.texture_cache.size;
  if (kind == "pixel_cache") return unit.selective.pixel_cache.size;
  if (kind == "l2") return unit.memory.l2.size;
  throw std::logic_error("no size is known of the cache " + kind);
}

}  // namespace

std::string kind_of_cache(const std::string& path) {
  const std::string name = path.substr(path.rfind('.') + 1);  // npos + 1 is 0
  return name.compare(0, 7, "l2_bank") == 0 ? "l2" : name;
}

std::uint64_t CacheReuse::misses(std::uint64_t size) const {
  std::uint64_t sum = first_uses;
  for (std::uint64_t distance = size; distance < distances.size(); ++distance) sum += distances[distance];
  return sum;
}

void add(std::vector<CacheReuse>& sum, const std::vector<CacheReuse>& frame) {
  if (sum.empty()) {
    sum = frame;
    return;
  }
  for (std::size_t i = 0; i < frame.size(); ++i) {
    CacheReuse& s = sum[i];
    const CacheReuse& f = frame[i];
    s.requests += f.requests;
    s.first_uses += f.first_uses;
    s.distances.resize(std::max(s.distances.size(), f.distances.size()));
    for (std::size_t distance = 0; distance < f.distances.size(); ++distance)
      s.distances[distance] += f.distances[distance];
    s.windows.insert(s.windows.end(), f.windows.begin(), f.windows.end());
  }
}

void ReuseProfile::make_stacks(const std::vector<std::string>& caches) {
  for (const std::string& path : caches) {
    const std::string name = kind_of_cache(path);
    std::size_t kind = 0;
    while (kind < kinds_.size() && kinds_[kind].name != name) ++kind;
    if (kind == kinds_.size()) {
      kinds_.emplace_back();
      kinds_[kind].name = name;
      kinds_[kind].lines = size_of(name, unit_) / hw::line_bytes;
    }
    const bool next_bank = name == "l2" && kinds_[kind].caches != 0;
    if (next_bank) {
      const auto first = std::find_if(stacks_.begin(), stacks_.end(), [&](const Stack& s) { return s.kind == kind; });
      stack_of_.push_back(static_cast<std::size_t>(first - stacks_.begin()));
      continue;
    }
    ++kinds_[kind].caches;
    stack_of_.push_back(stacks_.size());
    stacks_.emplace_back();
    stacks_.back().kind = kind;
  }
}

void ReuseProfile::begin_frame(const std::vector<std::string>& caches) {
  if (stack_of_.empty()) make_stacks(caches);
  for (CacheReuse& kind : kinds_) {
    kind.requests = kind.first_uses = 0;
    kind.distances.clear();
    kind.windows.clear();
  }
  for (Stack& stack : stacks_) {
    stack.distance.clear();
    stack.used.clear();
    stack.lines.clear();
    stack.requests.clear();
  }
}

void ReuseProfile::request(std::size_t cache, hw::Cycle cycle, const hw::MemoryRequest& request) {
  Stack& stack = stacks_[stack_of_[cache]];
  CacheReuse& kind = kinds_[stack.kind];
  const std::uint64_t line = request.line / hw::line_bytes;
  const std::uint64_t distance = stack.distance.use(line);
  ++kind.requests;
  if (distance == StackDistance::never_used) {
    ++kind.first_uses;
  } else {
    if (distance >= kind.distances.size()) kind.distances.resize(distance + 1);
    ++kind.distances[distance];
  }
  const std::uint64_t window = cycle / window_;
  if (window >= stack.lines.size()) {
    stack.lines.resize(window + 1);
    stack.requests.resize(window + 1);
  }
  ++stack.requests[window];
  std::uint64_t& used = stack.used[line];
  if (used != window + 1) ++stack.lines[window];
  used = window + 1;
}

void ReuseProfile::forget(std::size_t cache, hw::Address line) {
  stacks_[stack_of_[cache]].distance.forget(line / hw::line_bytes);
}

void ReuseProfile::forget_all(std::size_t cache) { stacks_[stack_of_[cache]].distance.clear(); }

std::vector<CacheReuse> ReuseProfile::end_frame(std::uint32_t index, std::uint64_t cycles) {
  const std::uint64_t windows = (cycles + window_ - 1) / window_;
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
    for (std::uint64_t window = 0; window < windows; ++window) {
      WorkingSet set{index, window * window_};
      for (const Stack& stack : stacks_) {
        if (stack.kind != kind || window >= stack.lines.size()) continue;
        set.requests += stack.requests[window];
        set.lines += static_cast<double>(stack.lines[window]);
        set.largest = std::max(set.largest, stack.lines[window]);
      }
      set.lines /= static_cast<double>(kinds_[kind].caches);
      kinds_[kind].windows.push_back(set);
    }
  }
  return kinds_;
}

}  // namespace artu::sim
