// Who is told which lines the caches are asked for, in the order in which they serve the requests.
#pragma once

#include <string>
#include <vector>

#include "hw/fabric/memory_port.h"

namespace artu::hw {

/// Must not throw but in begin_frame.
class RequestSink {
 public:
  virtual ~RequestSink() = default;
  /// Paths of the caches, the same before every frame; below, caches are places in this list.
  virtual void begin_frame(const std::vector<std::string>& caches) = 0;
  virtual void request(std::size_t cache, Cycle cycle, const MemoryRequest& request) = 0;
  /// The line, or all, is not to be had from the cache any more.
  virtual void forget(std::size_t cache, Address line) = 0;
  virtual void forget_all(std::size_t cache) = 0;
};

}  // namespace artu::hw
