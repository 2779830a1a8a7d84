#include "sim/import/animation.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace artu::sim {
namespace {

glm::dquat quaternion(const double* v) { return glm::dquat(v[3], v[0], v[1], v[2]); }

void store_unit(glm::dquat q, double* out) {
  const double length = glm::length(q);
  q = length > 0 ? q / length : glm::dquat(1, 0, 0, 0);
  out[0] = q.x, out[1] = q.y, out[2] = q.z, out[3] = q.w;
}

}  // namespace

glm::dmat4 Trs::matrix() const {
  glm::dmat4 m = glm::mat4_cast(rotation);
  m[0] *= scale.x;
  m[1] *= scale.y;
  m[2] *= scale.z;
  m[3] = glm::dvec4(translation, 1.0);
  return m;
}

void Channel::sample(double time, double* out) const {
  const bool cubic = interpolation == Interpolation::cubic;
  const std::size_t step = cubic ? 3 * width : width;
  const std::size_t value = cubic ? width : 0;  // offset of the value inside a key
  const auto key = [&](std::size_t k) { return values.data() + k * step + value; };
  // The last key that is not after `time`, and its successor.
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  const std::size_t next = static_cast<std::size_t>(after - times.begin());
  const bool rotation = path == ChannelPath::rotation;

  if (next == 0 || next == times.size() || interpolation == Interpolation::step) {
    const double* v = key(next == 0 ? 0 : next - 1);
    std::copy(v, v + width, out);
    if (rotation) store_unit(quaternion(v), out);
    return;
  }
  const std::size_t last = next - 1;
  const double span = times[next] - times[last];
  const double s = (time - times[last]) / span;
  if (!cubic) {
    if (rotation) {
      store_unit(glm::slerp(glm::normalize(quaternion(key(last))), glm::normalize(quaternion(key(next))), s), out);
      return;
    }
    for (std::size_t i = 0; i < width; ++i) out[i] = key(last)[i] + (key(next)[i] - key(last)[i]) * s;
    return;
  }
  const double s2 = s * s, s3 = s2 * s;
  for (std::size_t i = 0; i < width; ++i) {
    const double out_tangent = key(last)[width + i] * span;
    const double in_tangent = values[next * step + i] * span;
    out[i] = (2 * s3 - 3 * s2 + 1) * key(last)[i] + (s3 - 2 * s2 + s) * out_tangent + (3 * s2 - 2 * s3) * key(next)[i] +
             (s3 - s2) * in_tangent;
  }
  if (rotation) store_unit(quaternion(out), out);
}

bool Channel::varies() const {
  if (times.size() < 2) return false;
  const bool cubic = interpolation == Interpolation::cubic;
  const std::size_t step = cubic ? 3 * width : width;
  for (std::size_t k = 0; k < times.size(); ++k) {
    for (std::size_t i = 0; i < step; ++i) {
      const bool tangent = cubic && (i < width || i >= 2 * width);
      if (tangent ? values[k * step + i] != 0 : values[k * step + i] != values[i]) return true;
    }
  }
  return false;
}

void Clip::measure() {
  length = 0;
  for (const Channel& channel : channels) length = std::max(length, channel.times.back());
}

double clip_time(double time, double length, bool loop) {
  if (!(length > 0)) return 0;
  if (!loop) return std::clamp(time, 0.0, length);
  const double wrapped = std::fmod(time, length);
  return wrapped < 0 ? wrapped + length : wrapped;
}

}  // namespace artu::sim
