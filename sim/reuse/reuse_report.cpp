#include "sim/reuse/reuse_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace artu::sim {

namespace {

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  return fmt::format("{:.2f} %", 100 * share(part, whole));
}

std::string kib(double lines) { return fmt::format("{:.6g} KiB", lines * hw::line_bytes / 1024); }

/// The smallest power of two with at most a tenth more misses than first uses.
std::uint64_t size_that_does(const CacheReuse& reuse) {
  std::uint64_t lines = 1;
  while (10 * reuse.misses(lines) > 11 * reuse.first_uses) lines *= 2;
  return lines;
}

}  // namespace

std::vector<ModelMisses> misses_of_model(const std::vector<CacheReuse>& kinds, const hw::Statistics& statistics) {
  std::vector<ModelMisses> out(kinds.size());
  for (const hw::Statistic& s : statistics) {
    for (std::size_t kind = 0; kind < out.size(); ++kind) {
      if (kind_of_cache(s.block) != kinds[kind].name) continue;
      if (s.name == "reads" || s.name == "writes") out[kind].requests += s.value;
      if (s.name == "misses") out[kind].misses += s.value;
      if (s.name == "merged_misses") out[kind].misses -= s.value;
    }
  }
  return out;
}

std::vector<std::uint64_t> sizes_of_curve(const CacheReuse& reuse) {
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t power = 1;; power *= 2) {
    for (const std::uint64_t size : {power, power + power / 2}) {
      if (!sizes.empty() && size == sizes.back()) continue;
      sizes.push_back(size);
      if (size >= reuse.enough()) return sizes;
    }
  }
}

std::string format_reuse(const std::vector<CacheReuse>& kinds, const std::vector<ModelMisses>& model,
                         std::uint64_t window) {
  std::string out =
      fmt::format("{:<16}{:>7}{:>11}{:>12}{:>10}{:>10}{:>10}{:>10}{:>10}{:>12}{:>14}{:>14}\n", "cache", "caches",
                  "size", "requests", "model", "LRU", "half", "twice", "any size", "enough", "working set", "largest");
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const CacheReuse& k = kinds[i];
    double lines = 0;
    std::uint64_t largest = 0;
    for (const WorkingSet& set : k.windows) {
      lines += set.lines;
      largest = std::max(largest, set.largest);
    }
    if (!k.windows.empty()) lines /= static_cast<double>(k.windows.size());
    out += fmt::format("{:<16}{:>7}{:>11}{:>12}{:>10}{:>10}{:>10}{:>10}{:>10}{:>12}{:>14}{:>14}\n", k.name, k.caches,
                       kib(static_cast<double>(k.lines)), k.requests, percent(model[i].misses, model[i].requests),
                       percent(k.misses(k.lines), k.requests), percent(k.misses(k.lines / 2), k.requests),
                       percent(k.misses(2 * k.lines), k.requests), percent(k.first_uses, k.requests),
                       k.requests == 0 ? "-" : kib(static_cast<double>(size_that_does(k))),
                       fmt::format("{:.1f} KiB", lines * hw::line_bytes / 1024), kib(static_cast<double>(largest)));
  }
  return out +
         fmt::format("enough: at most a tenth more misses than without limit; working set: of {} cycles\n", window);
}

std::string curves_csv(const std::vector<CacheReuse>& kinds) {
  std::string out = "cache,caches,bytes,requests,misses,miss_ratio\n";
  for (const CacheReuse& k : kinds) {
    std::vector<std::uint64_t> sizes = sizes_of_curve(k);
    for (const std::uint64_t size : sizes) {
      const std::uint64_t misses = k.misses(size);
      out += fmt::format("{},{},{},{},{},{:.8g}\n", k.name, k.caches, size * hw::line_bytes, k.requests, misses,
                         share(misses, k.requests));
    }
  }
  return out;
}

std::string working_set_csv(const std::vector<CacheReuse>& kinds) {
  std::string out = "cache,frame,cycle,requests,mean_bytes,largest_bytes\n";
  for (const CacheReuse& k : kinds) {
    for (const WorkingSet& set : k.windows) {
      out += fmt::format("{},{},{},{},{:.8g},{}\n", k.name, set.frame, set.cycle, set.requests,
                         set.lines * hw::line_bytes, set.largest * hw::line_bytes);
    }
  }
  return out;
}

}  // namespace artu::sim
