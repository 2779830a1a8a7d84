// The triangles of one class (static or dynamic) in an Embree tree that finds candidates; the tests are ref/'s own.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ref/binary64_tests.h"
#include "ref/hit_tests.h"
#include "ref/padding.h"

struct RTCDeviceTy;
struct RTCSceneTy;
struct RTCBoundsFunctionArguments;
struct RTCIntersectFunctionNArguments;
struct RTCOccludedFunctionNArguments;

namespace artu::ref {

/// RAII of Embree's device, single threaded.
class EmbreeDevice {
 public:
  EmbreeDevice();
  RTCDeviceTy* get() const { return device_.get(); }
  /// Throws std::runtime_error if Embree reports an error since the last call.
  void check(const char* what) const;

 private:
  struct Release {
    void operator()(RTCDeviceTy* device) const;
  };
  std::unique_ptr<RTCDeviceTy, Release> device_;
};

/// Embree keeps a pointer to this object, hence neither copies nor moves.  Tests is HitTests or Binary64Tests.
template <class Tests>
class EmbreeSceneOf {
 public:
  using Ray = typename Tests::Ray;
  using Hit = HitIn<typename Tests::Number>;

  explicit EmbreeSceneOf(const EmbreeDevice& device, const Tests& tests = Tests());
  EmbreeSceneOf(const EmbreeSceneOf&) = delete;
  EmbreeSceneOf& operator=(const EmbreeSceneOf&) = delete;

  /// Takes the mesh's triangles; their global ids are `first_id`, `first_id + 1`, ...  `build` must follow.
  void set(const traces::Mesh& mesh, std::int64_t first_id);
  /// Builds the tree; boxes are widened by `padding` on each side.
  void build(double padding);

  const Extent& extent() const { return extent_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  std::int64_t first_id() const { return first_id_; }
  double padding() const { return padding_; }
  const Tests& tests() const { return tests_; }

  /// Improves `best` by the closest hit of these triangles.  The ray is one of `tests()`.
  void closest(const Ray& ray, Hit& best) const;
  /// Whether any triangle is hit.
  bool occluded(const Ray& ray) const;

 private:
  struct Release {
    void operator()(RTCSceneTy* scene) const;
  };
  Box padded(std::uint32_t triangle) const;
  static void bounds_callback(const RTCBoundsFunctionArguments* args);
  static void intersect_callback(const RTCIntersectFunctionNArguments* args);
  static void occluded_callback(const RTCOccludedFunctionNArguments* args);

  const EmbreeDevice& device_;
  const Tests tests_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> oversized_;  // beyond Embree's range of coordinates: tested one by one
  Extent extent_;
  std::int64_t first_id_ = 0;
  double padding_ = 0;
  std::unique_ptr<RTCSceneTy, Release> scene_;  // null where there is no triangle
};
using EmbreeScene = EmbreeSceneOf<HitTests>;

}  // namespace artu::ref
