// The phases of a frame, as bits: which blocks have a part in what is going on.
#pragma once

namespace artu::hw {

enum Phase : unsigned { phase_start = 1, phase_build = 2, phase_first = 4, phase_selective = 8, phase_flush = 16 };

inline const char* phase_name(unsigned phase) {
  switch (phase) {
    case phase_start:
      return "start";
    case phase_build:
      return "build";
    case phase_first:
      return "first";
    case phase_selective:
      return "selective";
    default:
      return "flush";
  }
}

}  // namespace artu::hw
