// What a process that will not return from main() has to do for scripts/coverage.
#pragma once

#ifdef ARTU_COVERAGE
extern "C" {
#include <gcov.h>
}
#endif

namespace artu::sim {

/// In a build that counts executed lines (preset coverage): writes the counts so far and begins anew. Otherwise
/// nothing.
inline void write_line_counts() {
#ifdef ARTU_COVERAGE
  __gcov_dump();
  __gcov_reset();
#endif
}

}  // namespace artu::sim
