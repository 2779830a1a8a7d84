// An axis of the plot: its range, its tics, and where a value lies on it.
#pragma once

#include <string>
#include <vector>

namespace artu::sim {

class PlotAxis {
 public:
  /// Holds all values, which are above 0; there must be one.  Logarithmic where they span more than a factor of 4.
  explicit PlotAxis(const std::vector<double>& values);

  /// 0 at the axis' beginning, 1 at its end.
  double position(double value) const;
  /// gnuplot's commands for the axis `name`, "x" or "y".
  std::string commands(char name) const;

 private:
  double scaled(double value) const;

  double lo_, hi_;
  bool logarithmic_;
};

}  // namespace artu::sim
