// `--trace`: the traces of a frame that a run writes, each in a file of its own (docs/viewers.md).
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "sim/viewers/trace_writer.h"

namespace artu::sim {

enum class TraceKind : std::uint8_t { perfetto, konata, vcd };
inline constexpr std::array trace_kinds = {TraceKind::perfetto, TraceKind::konata, TraceKind::vcd};

const char* trace_kind_name(TraceKind kind);
/// What a trace of this kind is called in a run's folder.
const char* trace_file_name(TraceKind kind);

struct TraceRequest {
  TraceKind kind = TraceKind::perfetto;
  std::string file;  // "" = in the run's folder
};

/// What is asked for.
struct TraceOptions {
  std::vector<TraceRequest> requests;
  hw::ActivityWindow window;
};

class TraceSet {
 public:
  /// Opens a file; refuses one that exists, unless `force`.  `shown` is its name when the run is over, `title` what the
  /// viewers call it.
  void add(TraceKind kind, const std::string& file, const std::string& shown, bool force, const std::string& title);
  /// Who must be told of the frame.
  std::vector<hw::ActivitySink*> sinks() const;
  /// After the frame.
  void close();
  /// One line a file: what it is, of how many cycles, how large.
  std::vector<std::string> summary() const;
  /// Whether the window lay behind the frame's end.
  bool empty() const;

 private:
  struct Trace {
    TraceKind kind;
    std::string shown;
    std::unique_ptr<TraceWriter> writer;
  };
  std::vector<Trace> traces_;
};

}  // namespace artu::sim
