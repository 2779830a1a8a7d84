#include <fmt/format.h>

#include "sim/bench/report.h"

namespace artu::sim {
namespace {

template <class T>
std::string cell(const std::optional<T>& value) {
  return value ? fmt::format(",{}", *value) : ",";
}

/// A name in quotes, as RFC 4180 has it.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

std::string bench_csv(const BenchReport& report) {
  std::string out =
      "scene,frame,width,height,triangles,mode,seconds,spread,golden_ratio,functional_ratio,cycles,low,high,error,"
      "covered,primary_rays,node_visits,peak_bytes\n";
  for (const BenchScene& scene : report.scenes) {
    for (const ModeResult& r : scene.results) {
      out += fmt::format("{},{},{},{},{},{},{},{}", quoted(scene.name), scene.frame, scene.width, scene.height,
                         scene.triangles, r.mode, r.median(), r.spread());
      out += cell(scene.ratio(r, golden_mode)) + cell(scene.ratio(r, fidelity_name(Fidelity::functional)));
      out += cell(r.cycles);
      out += r.interval ? fmt::format(",{},{}", r.interval->low, r.interval->high) : ",,";
      out += cell(scene.error(r)) + cell(scene.covered(r));
      out += fmt::format(",{},{},{}\n", r.primary_rays, r.node_visits, r.peak_bytes);
    }
  }
  return out;
}

std::string growth_csv(const BenchReport& report) {
  std::string out = "what,value,mode,seconds,spread,peak_bytes\n";
  for (const Growth& growth : report.growth) {
    for (const GrowthPoint& point : growth.points) {
      for (const ModeResult& r : point.results) {
        out +=
            fmt::format("{},{},{},{},{},{}\n", growth.what, point.value, r.mode, r.median(), r.spread(), r.peak_bytes);
      }
    }
  }
  return out;
}

}  // namespace artu::sim
