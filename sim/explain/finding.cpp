#include "sim/explain/finding.h"

#include <fmt/format.h>

#include <algorithm>

namespace artu::sim {

const char* name_of(Bound bound) {
  static const char* const names[] = {"traversal",      "intersection",
                                      "hit points",     "shading",
                                      "L1 caches",      "L2",
                                      "DRAM bandwidth", "DRAM latency",
                                      "L2 latency",     "pipeline latency",
                                      "queue depth",    "candidate extraction",
                                      "frame writer",   "dispatcher",
                                      "uneven cores",   "too few pixels in flight",
                                      "tree build",     "start",
                                      "write-back"};
  return names[static_cast<std::size_t>(bound)];
}

namespace {

constexpr double full = 0.75;    // from here on a resource binds
constexpr double taken = 0.7;    // from here on places are
constexpr double fed = 0.6;      // from here on contexts are, a frame's beginning and end included
constexpr double tie = 0.9;      // of the larger share: both bind
constexpr double rival = 0.8;    // of the longer phase
constexpr double loaded = 2;     // a DRAM read takes so many times as long as alone
constexpr double uneven = 1.25;  // the core with the most pixels over the mean

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

Bound bound_of(Resource resource) {
  switch (resource) {
    case Resource::box_testers:
    case Resource::traversal_steps:
      return Bound::traversal;
    case Resource::triangle_testers:
      return Bound::intersection;
    case Resource::hit_points:
      return Bound::hit_points;
    case Resource::shading:
      return Bound::shading;
    case Resource::node_caches:
    case Resource::triangle_caches:
    case Resource::texture_caches:
      return Bound::l1;
    case Resource::l2_banks:
      return Bound::l2;
    case Resource::dram_buses:
    case Resource::dram_rows:
      return Bound::dram_bandwidth;
    case Resource::dispatcher:
      return Bound::dispatcher;
    case Resource::extractor:
      return Bound::candidate_extraction;
    case Resource::frame_writer:
      return Bound::frame_writer;
    case Resource::in_flight:
      break;
  }
  return Bound::pipeline_latency;
}

std::string evidence_of(const Accounting& a, Resource resource) {
  const double share = a.share(resource);
  if (resource == Resource::in_flight) {
    return fmt::format("the pipelines alone keep the pixels in flight for {} of the passes' cycles", percent(share));
  }
  if (resource == Resource::dram_buses) {
    const double data = a.need(resource) / a.passes(), lost = a.dram_lost / a.passes();
    return fmt::format("the buses carry data in {} of the passes' cycles, and turn round or wait for refreshes in {}",
                       percent(data), percent(lost));
  }
  return fmt::format("the {} {} needed in {} of the passes' cycles", name_of(resource),
                     std::string(name_of(resource)).back() == 's' ? "are" : "is", percent(share));
}

Finding throughput(const Accounting& a, Resource resource) {
  return {bound_of(resource), a.passes(), evidence_of(a, resource), resource, true, {}};
}

Finding waiting(const Accounting& a, Bound bound, Place place, std::string evidence) {
  return {bound, a.passes(), std::move(evidence), {}, false, place};
}

/// The most needed first.
std::vector<Resource> by_share(const Accounting& a) {
  std::vector<Resource> order;
  for (std::size_t i = 0; i < resource_count; ++i) order.push_back(static_cast<Resource>(i));
  std::stable_sort(order.begin(), order.end(), [&](Resource x, Resource y) { return a.share(x) > a.share(y); });
  return order;
}

/// Resources that could not be asked for much more.
std::vector<Finding> busy_resources(const Accounting& a) {
  const std::vector<Resource> order = by_share(a);
  std::vector<Finding> found;
  for (const Resource resource : order) {
    if (a.share(resource) < full || a.share(resource) < tie * a.share(order[0])) break;
    const Bound bound = bound_of(resource);
    const auto said = [bound](const Finding& finding) { return finding.bound == bound; };
    if (std::none_of(found.begin(), found.end(), said)) found.push_back(throughput(a, resource));
  }
  return found;
}

/// No resource is needed so much, and places for what is under way are taken.  Where several are, the one nearest to
/// the DRAM holds up those before it.
std::vector<Finding> full_places(const Accounting& a) {
  const auto l1 = {Place::node_misses, Place::triangle_misses, Place::texture_misses};
  const Place of_l1 =
      *std::max_element(l1.begin(), l1.end(), [&](Place x, Place y) { return a.taken_of(x) < a.taken_of(y); });
  const std::pair<Bound, Place> places[] = {
      {Bound::queue_depth, Place::dram_reads}, {Bound::l2, Place::l2_misses}, {Bound::l1, of_l1}};
  for (const auto& [bound, place] : places) {
    if (a.taken_of(place) < taken) continue;
    return {waiting(a, bound, place,
                    fmt::format("{} of the {} are taken (Little's law), and no resource is needed so much",
                                percent(a.taken_of(place)), name_of(place)))};
  }
  return {};
}

/// Reads that queue in the DRAM are no matter of its latency, whatever its buses do: rows, turns or bursts of misses.
std::vector<Finding> loaded_dram(const Accounting& a) {
  const bool queues = a.dram_read_cycles >= loaded * a.dram_idle_cycles;
  if (!queues || a.to_dram < std::max(a.to_l2, a.in_pipelines)) return {};
  Finding finding = throughput(a, Resource::dram_buses);
  finding.evidence +=
      fmt::format("; a read takes {:.0f} cycles, {:.0f} of them alone", a.dram_read_cycles, a.dram_idle_cycles);
  return {finding};
}

/// The contexts are full: rays wait for answers, or are on their way.
Finding latency(const Accounting& a) {
  const double resident = std::max(a.resident, 1.0);
  const auto waits = [&](Bound bound, double cycles, const char* what) {
    return waiting(a, bound, Place::contexts,
                   fmt::format("{} of the contexts hold a pixel, and {} of its time {}",
                               percent(a.taken_of(Place::contexts)), percent(std::min(cycles / resident, 1.0)), what));
  };
  const double longest = std::max({a.to_dram, a.to_l2, a.in_pipelines});
  // What is left is waiting for one's turn, for the most where most is asked for.
  const double turns = resident - a.to_dram - a.to_l2 - a.in_pipelines;
  const Resource most = by_share(a)[0];
  if (turns > longest && a.share(most) >= 0.5) {
    Finding queued = throughput(a, most);
    queued.evidence += fmt::format("; pixels wait for their turn {} of their time", percent(turns / resident));
    return queued;
  }
  if (longest == a.to_dram) return waits(Bound::dram_latency, a.to_dram, "waits for the DRAM");
  if (longest == a.to_l2) return waits(Bound::l2_latency, a.to_l2, "is on the way to the L2 and back");
  return waits(Bound::pipeline_latency, a.in_pipelines, "is in pipelines");
}

/// Contexts are empty: something before the cores does not feed them.
Finding starved(const Accounting& a, const hw::UnitConfig& unit) {
  const double empty = 1 - a.taken_of(Place::contexts);
  const double for_each = a.pixels / (static_cast<double>(unit.core.count) * unit.core.contexts);
  if (a.unevenness >= uneven && for_each >= 1) {  // fewer cannot be shared out evenly
    return waiting(a, Bound::uneven_cores, Place::contexts,
                   fmt::format("one core has {:.2f} times the mean number of pixels; {} of the contexts are empty",
                               a.unevenness, percent(empty)));
  }
  const std::string contexts = fmt::format("; {} of the contexts are empty", percent(empty));
  if (a.share(Resource::extractor) >= 0.5) {
    Finding extractor = throughput(a, Resource::extractor);
    extractor.evidence += contexts;
    return extractor;
  }
  if (a.extractor_waits >= 0.5) {
    return waiting(
        a, Bound::candidate_extraction, Place::pixel_misses,
        fmt::format("the extractor waits for its pixel cache in {} of the passes' cycles", percent(a.extractor_waits)) +
            contexts);
  }
  return waiting(a, Bound::too_few_pixels, Place::contexts,
                 fmt::format("{} of the contexts are empty: {:.0f} traced pixels are {:.2g} for each of them",
                             percent(empty), a.pixels, for_each));
}

std::vector<Finding> in_passes(const Accounting& a, const hw::UnitConfig& unit) {
  if (a.passes() == 0) return {};
  std::vector<Finding> found = busy_resources(a);
  if (found.empty()) found = loaded_dram(a);
  if (found.empty()) found = full_places(a);
  if (found.empty()) found = {a.taken_of(Place::contexts) >= fed ? latency(a) : starved(a, unit)};
  return found;
}

/// Beside the passes the builder is one of their resources; and rays that wait for its tree keep contexts from others,
/// so that it binds earlier than one that nobody waits for.
bool builder_binds(const Accounting& a, const hw::UnitConfig& unit) {
  if (!a.builder_overlaps) return false;
  const double contexts = static_cast<double>(unit.core.count) * unit.core.contexts;
  return a.builder >= full * a.cycles || (a.builder >= 0.5 * a.cycles && a.tree_waits >= contexts);
}

Finding beside_passes(const Accounting& a) {
  std::string evidence = fmt::format("the builder is busy in {} of the cycles, beside the passes",
                                     percent(std::min(a.builder / a.cycles, 1.0)));
  if (a.tree_waits > 0) evidence += fmt::format("; {:.0f} rays wait for its tree with their contexts", a.tree_waits);
  return {Bound::tree_build, a.builder, std::move(evidence), {}, false, {}};
}

Finding phase(const Accounting& a, Bound bound, double cycles, const char* what) {
  return {bound,
          cycles,
          fmt::format("{} takes {} of the cycles, and nothing else goes on", what, percent(cycles / a.cycles)),
          {},
          false,
          {}};
}

}  // namespace

std::vector<Finding> findings(const Accounting& a, const hw::UnitConfig& unit) {
  std::vector<Finding> found = in_passes(a, unit);
  const bool overlapped = builder_binds(a, unit);
  if (overlapped) {
    if (busy_resources(a).empty()) found.clear();  // the others only seem to be short of work
    found.push_back(beside_passes(a));
  }
  std::vector<Finding> phases = {phase(a, Bound::tree_build, overlapped ? 0 : a.build, "the tree's build"),
                                 phase(a, Bound::write_back, a.flush, "the write-back"),
                                 phase(a, Bound::start, a.start, "reading the descriptor and the lights")};
  found.insert(found.end(), phases.begin(), phases.end());
  std::stable_sort(found.begin(), found.end(), [](const Finding& x, const Finding& y) { return x.cycles > y.cycles; });
  const double longest = found[0].cycles;
  found.erase(std::remove_if(found.begin(), found.end(), [&](const Finding& f) { return f.cycles < rival * longest; }),
              found.end());
  return found;
}

}  // namespace artu::sim
