#include "hw/functional/render.h"

namespace artu::hw {

FunctionalCounts FunctionalUnit::run(Address descriptor, std::uint32_t stack_needed, PixelRecords& records) const {
  NoTap tap;
  return run(descriptor, stack_needed, records, tap);
}

}  // namespace artu::hw
