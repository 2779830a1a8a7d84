// What `artu reuse` prints, writes and draws.
#pragma once

#include <string>
#include <vector>

#include "hw/fabric/statistics.h"
#include "sim/reuse/reuse_profile.h"

namespace artu::sim {

/// Misses of the event model, of all caches of a kind, those on lines on their way left out.
struct ModelMisses {
  std::uint64_t requests = 0, misses = 0;
};

/// By kind.
std::vector<ModelMisses> misses_of_model(const std::vector<CacheReuse>& kinds, const hw::Statistics& statistics);

/// Lines of a cache: 1, 2, 3, 4, 6, 8, 12 ... to the first with which only first uses miss.
std::vector<std::uint64_t> sizes_of_curve(const CacheReuse& reuse);

std::string format_reuse(const std::vector<CacheReuse>& kinds, const std::vector<ModelMisses>& model,
                         std::uint64_t window);

/// cache,caches,bytes,requests,misses,miss_ratio
std::string curves_csv(const std::vector<CacheReuse>& kinds);
/// cache,frame,cycle,requests,mean_bytes,largest_bytes
std::string working_set_csv(const std::vector<CacheReuse>& kinds);

/// gnuplot's data and script: the curves above, the working set below.
std::string reuse_data(const std::vector<CacheReuse>& kinds, const std::vector<ModelMisses>& model);
std::string reuse_script(const std::vector<CacheReuse>& kinds, const std::string& title, std::uint64_t window);

inline constexpr const char* reuse_plot = "reuse";  // the name of its files

}  // namespace artu::sim
