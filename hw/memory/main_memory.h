// What stands below the L2: the built-in DRAM (hw/memory/dram.h) or the way to a memory outside (hw/border).
#pragma once

#include <functional>
#include <memory>

#include "hw/fabric/memory_port.h"

namespace artu::hw {

class MainMemory : public Block {
 public:
  using Block::Block;
  virtual void bind(MemoryLink& link) = 0;
  /// In the present frame, for the accounting laws.
  virtual std::uint64_t read_bytes() const = 0;
  virtual std::uint64_t write_bytes() const = 0;
};

/// Makes the memory in the DRAM's clock domain, while the unit is being constructed.
using MakeMemory = std::function<std::unique_ptr<MainMemory>(ClockDomain&)>;

}  // namespace artu::hw
