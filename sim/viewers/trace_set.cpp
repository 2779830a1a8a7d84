#include "sim/viewers/trace_set.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/viewers/konata.h"
#include "sim/viewers/perfetto.h"
#include "sim/viewers/vcd.h"

namespace artu::sim {

const char* trace_kind_name(TraceKind kind) {
  static constexpr const char* names[] = {"perfetto", "konata", "vcd"};
  return names[static_cast<std::size_t>(kind)];
}

const char* trace_file_name(TraceKind kind) {
  static constexpr const char* names[] = {"trace.pftrace", "trace.kanata", "trace.vcd"};
  return names[static_cast<std::size_t>(kind)];
}

void TraceSet::add(TraceKind kind, const std::string& file, const std::string& shown, bool force,
                   const std::string& title) {
  std::unique_ptr<TraceWriter> writer;
  switch (kind) {
    case TraceKind::perfetto:
      writer = std::make_unique<PerfettoTrace>(file, force, title);
      break;
    case TraceKind::konata:
      writer = std::make_unique<KonataTrace>(file, force);
      break;
    case TraceKind::vcd:
      writer = std::make_unique<VcdTrace>(file, force);
      break;
  }
  traces_.push_back({kind, shown, std::move(writer)});
}

std::vector<hw::ActivitySink*> TraceSet::sinks() const {
  std::vector<hw::ActivitySink*> sinks;
  for (const Trace& trace : traces_) sinks.push_back(trace.writer.get());
  return sinks;
}

void TraceSet::close() {
  for (const Trace& trace : traces_) trace.writer->close();
}

std::vector<std::string> TraceSet::summary() const {
  std::vector<std::string> lines;
  for (const Trace& trace : traces_) {
    const auto bytes = static_cast<double>(trace.writer->bytes());
    std::string line = fmt::format("{}: {}, {} cycles, {:.1f} MB", trace.shown, trace_kind_name(trace.kind),
                                   trace.writer->cycles(), bytes / 1e6);
    if (trace.writer->cycles() != 0) {
      line += fmt::format(", {:.0f} MB a Mcycle", bytes / static_cast<double>(trace.writer->cycles()));
    }
    lines.push_back(line);
  }
  return lines;
}

bool TraceSet::empty() const {
  return std::any_of(traces_.begin(), traces_.end(), [](const Trace& trace) { return trace.writer->cycles() == 0; });
}

}  // namespace artu::sim
