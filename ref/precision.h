// Widths of the unit's three datapaths (docs/arithmetic.md section 1, "Formats").
#pragma once

namespace artu::ref {

/// Stored fraction bits, 7 ... 23 each; 23 is binary32.
struct Precision {
  int box = 23, triangle = 23, shading = 23;

  /// Of the two tests, which what protects one from the other depends on.
  int narrower_test() const { return box < triangle ? box : triangle; }
};

}  // namespace artu::ref
