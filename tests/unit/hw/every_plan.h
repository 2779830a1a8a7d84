// Every stride with every kind of passes.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "hw/unit_config.h"

namespace artu::hw::test {

/// Calls `test` with (stride, passes).
template <class Test>
void for_every_stride_and_passes(const Test& test) {
  for (std::uint32_t stride : {2u, 4u, 8u}) {
    for (Passes passes : {Passes::horizontal_vertical, Passes::average}) {
      SCOPED_TRACE("stride " + std::to_string(stride) + (passes == Passes::average ? ", average" : ""));
      test(stride, passes);
    }
  }
}

}  // namespace artu::hw::test
