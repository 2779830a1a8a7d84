// What a campaign compares: anything that answers rays.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "hw/datapath/walk.h"

namespace artu::sim {

/// The winner of a ray; all zero without a hit.
struct Answer {
  bool hit = false;
  std::uint32_t primitive = 0;
  hw::TriangleHit at{0, 0, 0, 0};

  /// Bit by bit.
  friend bool operator==(const Answer& a, const Answer& b) {
    return a.hit == b.hit && a.primitive == b.primitive && hw::bits_of(a.at.t) == hw::bits_of(b.at.t) &&
           hw::bits_of(a.at.U) == hw::bits_of(b.at.U) && hw::bits_of(a.at.V) == hw::bits_of(b.at.V) &&
           hw::bits_of(a.at.det) == hw::bits_of(b.at.det);
  }
  friend bool operator!=(const Answer& a, const Answer& b) { return !(a == b); }
};

inline Answer answer_of(const hw::Found& found) {
  if (!found.hit) return {};
  return {true, found.primitive, found.best};
}

class Subject {
 public:
  explicit Subject(std::string name) : name_(std::move(name)) {}
  virtual ~Subject() = default;
  const std::string& name() const { return name_; }

  /// `ray` is set up by hw; a subject with a set-up of its own takes origin, direction and tmax.
  virtual Answer closest(const hw::Ray& ray) const = 0;
  virtual bool occluded(const hw::Ray& ray) const = 0;
  /// Whether this ray costs so much that it is only asked with the sample that brute force answers.
  virtual bool is_slow(const hw::Ray&) const { return false; }

 private:
  std::string name_;
};

using SubjectPointer = std::unique_ptr<Subject>;

}  // namespace artu::sim
