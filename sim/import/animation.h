// Key-framed motion: what a clip holds and its value at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

namespace artu::sim {

struct Trs {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  // w, x, y, z
  glm::dvec3 scale{1.0};

  glm::dmat4 matrix() const;
};

enum class Interpolation : std::uint8_t { step, linear, cubic };
enum class ChannelPath : std::uint8_t { translation, rotation, scale, weights };

/// One property of one node over time.  `values` holds `width` numbers a key, or for a cubic spline three times
/// as many: in-tangent, value, out-tangent (as glTF does).  Rotations are x, y, z, w.
struct Channel {
  int node = -1;
  ChannelPath path = ChannelPath::translation;
  Interpolation interpolation = Interpolation::linear;
  std::size_t width = 3;
  std::vector<double> times;  // seconds, not decreasing, at least one
  std::vector<double> values;

  /// The `width` numbers at `time`, clamped to the first and last key; a rotation is of unit length.
  void sample(double time, double* out) const;
  /// Whether the value can differ between two times.
  bool varies() const;
};

struct Clip {
  std::string name;
  double length = 0;  // seconds: the last key of all channels
  std::vector<Channel> channels;

  void measure();  // sets `length`
};

/// The time inside a clip of this length: modulo if `loop`, else clamped.
double clip_time(double time, double length, bool loop);

}  // namespace artu::sim
