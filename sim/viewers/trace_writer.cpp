#include "sim/viewers/trace_writer.h"

namespace artu::sim {

void TraceWriter::write(std::string_view text) noexcept {
  if (failure_) return;
  try {
    file_.write(text);
    bytes_ += text.size();
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void TraceWriter::close() {
  if (failure_) std::rethrow_exception(failure_);
  file_.close();
}

}  // namespace artu::sim
