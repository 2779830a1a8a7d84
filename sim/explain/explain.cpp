#include "sim/explain/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "traces/error.h"

namespace artu::sim {

void require_exact(Fidelity fidelity, const std::string& where) {
  if (is_exact(fidelity)) return;
  throw InputError(where, fmt::format("{} does not count what every block does in every cycle; a run with "
                                      "--fidelity event would be right",
                                      fidelity_name(fidelity)));
}

Explanation explain(const Totals& totals, const hw::UnitConfig& unit) {
  require_exact(totals.fidelity, "explain");
  Explanation out;
  out.frames = totals.frames;
  out.account = account(totals, unit);
  out.found = findings(out.account, unit);
  std::vector<Advice> rest;
  for (const Finding& finding : out.found) {
    std::vector<Advice> advice = advice_on(finding, totals, unit);
    if (advice.empty()) continue;
    out.advice.push_back(advice[0]);
    rest.insert(rest.end(), advice.begin() + 1, advice.end());
  }
  for (const Advice& advice : rest) {
    const auto same = [&](const Advice& other) { return other.parameter == advice.parameter; };
    if (std::none_of(out.advice.begin(), out.advice.end(), same)) out.advice.push_back(advice);
  }
  if (out.advice.size() > 3) out.advice.resize(3);
  return out;
}

namespace {

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

/// 1234567 -> "1,234,567"
std::string grouped(double value) {
  std::string digits = fmt::format("{:.0f}", value);
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) digits.insert(at, ",");
  return digits;
}

std::string bottleneck_line(const Explanation& e) {
  if (e.found.size() == 1) return fmt::format("{}: {}", name_of(e.found[0].bound), e.found[0].evidence);
  std::string out = fmt::format("{} things bind: ", e.found.size() == 2 ? "two" : "several");
  for (std::size_t i = 0; i < e.found.size(); ++i) {
    out += fmt::format("{}{}: {}", i == 0 ? "" : "; and ", name_of(e.found[i].bound), e.found[i].evidence);
  }
  return out;
}

std::string time_line(const Explanation& e) {
  const Accounting& a = e.account;
  const auto frames = static_cast<double>(e.frames);
  return fmt::format("{} cycles a frame: start {}, tree build {}, first pass {}, selective passes {}, write-back {}",
                     grouped(a.cycles / frames), percent(a.start / a.cycles), percent(a.build / a.cycles),
                     percent(a.first / a.cycles), percent(a.selective / a.cycles), percent(a.flush / a.cycles));
}

/// What else is asked of much, and what is in flight.
std::string beside_line(const Explanation& e) {
  const Accounting& a = e.account;
  std::vector<Resource> order;
  for (std::size_t i = 0; i < resource_count; ++i) {
    const auto resource = static_cast<Resource>(i);
    const auto said = [resource](const Finding& f) { return f.throughput && f.resource == resource; };
    if (std::none_of(e.found.begin(), e.found.end(), said)) order.push_back(resource);
  }
  std::stable_sort(order.begin(), order.end(), [&](Resource x, Resource y) { return a.share(x) > a.share(y); });
  std::string out;
  for (std::size_t i = 0; i < 3; ++i) out += fmt::format("{} {}, ", name_of(order[i]), percent(a.share(order[i])));
  out += fmt::format("of the passes; {} of the contexts hold a pixel", percent(a.taken_of(Place::contexts)));
  if (a.dram_read_cycles > 0) {
    out +=
        fmt::format("; a DRAM read takes {:.0f} cycles, {:.0f} of them alone", a.dram_read_cycles, a.dram_idle_cycles);
  }
  return out;
}

std::string times(double now, double then) { return fmt::format("{:.2f} times as fast", now / then); }

/// Sizes in KiB or MiB, where they are whole; strings without their quotes.
std::string shown(const std::string& parameter, std::string value) {
  if (value.front() == '"') return value.substr(1, value.size() - 2);
  if (parameter.size() < 5 || parameter.compare(parameter.size() - 5, 5, ".size") != 0) return value;
  const std::uint64_t bytes = std::stoull(value);
  if (bytes % (1 << 20) == 0) return fmt::format("{} MiB", bytes >> 20);
  return bytes % 1024 == 0 ? fmt::format("{} KiB", bytes >> 10) : value;
}

std::string advice_text(const Explanation& e, const Advice& advice) {
  std::string out = fmt::format("{} {} -> {}: at most {}", advice.parameter, shown(advice.parameter, advice.from),
                                shown(advice.parameter, advice.to), times(e.account.cycles, advice.floor));
  if (advice.far < 0.99 * advice.floor) {
    out += fmt::format(", {:.2f} times however far", e.account.cycles / advice.far);
  }
  return out + fmt::format("; then {}", advice.then);
}

}  // namespace

std::string format_explanation(const Explanation& e) {
  std::string out;
  const auto line = [&](const char* name, const std::string& text) { out += fmt::format("{:<12}{}\n", name, text); };
  line("bottleneck", bottleneck_line(e));
  line("time", time_line(e));
  line("beside it", beside_line(e));
  line("turn", e.advice.empty() ? "nothing: no parameter gives more of it" : advice_text(e, e.advice[0]));
  std::string others;
  for (std::size_t i = 1; i < e.advice.size(); ++i) others += (i == 1 ? "" : ";  ") + advice_text(e, e.advice[i]);
  line("or", others.empty() ? "nothing else that the accounting knows of" : others);
  for (std::size_t i = 0; i < e.measured.size(); ++i) {
    const Advice& advice = e.advice[i];
    const auto cycles = static_cast<double>(e.measured[i]);
    line("measured",
         fmt::format("{} = {}: {} ({} cycles a frame)", advice.parameter, shown(advice.parameter, advice.to),
                     times(e.account.cycles, cycles), grouped(cycles / static_cast<double>(e.frames))));
  }
  return out;
}

}  // namespace artu::sim
