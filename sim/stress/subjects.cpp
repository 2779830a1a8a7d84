#include "sim/stress/subjects.h"

#include "sim/driver/geometry_image.h"

namespace artu::sim {
namespace {

class BruteForce : public Subject {
 public:
  BruteForce(const std::vector<Corners>& triangles, const hw::HitTests& tests)
      : Subject("brute"), triangles_(triangles), tests_(tests) {}

  Answer closest(const hw::Ray& ray) const override {
    hw::Found found;
    hw::TriangleHit hit;
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const Corners& t = triangles_[i];
      if (tests_.triangle(ray, t[0], t[1], t[2], hit)) hw::consider(hit, i, i, false, found);
    }
    return answer_of(found);
  }
  bool occluded(const hw::Ray& ray) const override {
    hw::TriangleHit hit;
    for (const Corners& t : triangles_) {
      if (tests_.triangle(ray, t[0], t[1], t[2], hit)) return true;
    }
    return false;
  }

 private:
  const std::vector<Corners>& triangles_;
  const hw::HitTests tests_;
};

class Walker : public Subject {
 public:
  Walker(std::string name, std::shared_ptr<const LaidDown> laid, const hw::HitTests& tests)
      : Subject(std::move(name)), laid_(std::move(laid)), tests_(tests) {}

  Answer closest(const hw::Ray& ray) const override {
    return answer_of(hw::walk(tests_, laid_->frame, laid_->image, ray, false));
  }
  bool occluded(const hw::Ray& ray) const override {
    return hw::walk(tests_, laid_->frame, laid_->image, ray, true).hit;
  }

 private:
  std::shared_ptr<const LaidDown> laid_;
  const hw::HitTests tests_;
};

traces::Vec3 plain(hw::Vector v) { return {v.x, v.y, v.z}; }

Answer answer_of(const ref::TracedHit& traced) {
  if (!traced.hit) return {};
  return {true, static_cast<std::uint32_t>(traced.primitive), {traced.t, traced.u, traced.v, traced.det}};
}

class GoldenTraversal : public Subject {
 public:
  GoldenTraversal(std::shared_ptr<const ref::Tracer> near, const ref::Extent& origins,
                  std::shared_ptr<const ref::Tracer> far, bool far_is_slow)
      : Subject("embree"), near_(std::move(near)), origins_(origins), far_(std::move(far)), far_is_slow_(far_is_slow) {}

  Answer closest(const hw::Ray& ray) const override {
    return answer_of(tracer(ray).closest(plain(ray.origin), plain(ray.direction), ray.tmax));
  }
  bool occluded(const hw::Ray& ray) const override {
    return tracer(ray).occluded(plain(ray.origin), plain(ray.direction), ray.tmax);
  }
  bool is_slow(const hw::Ray& ray) const override { return far_is_slow_ && &tracer(ray) == far_.get(); }

 private:
  const ref::Tracer& tracer(const hw::Ray& ray) const {
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      if (!(origins_.lo[axis] <= ray.origin[i] && ray.origin[i] <= origins_.hi[axis])) return *far_;
    }
    return *near_;
  }

  std::shared_ptr<const ref::Tracer> near_;
  ref::Extent origins_;
  std::shared_ptr<const ref::Tracer> far_;
  bool far_is_slow_;
};

class GoldenBruteForce : public Subject {
 public:
  explicit GoldenBruteForce(std::shared_ptr<const ref::Tracer> tracer) : Subject("ref"), tracer_(std::move(tracer)) {}

  Answer closest(const hw::Ray& ray) const override {
    return answer_of(tracer_->closest_of_all(plain(ray.origin), plain(ray.direction), ray.tmax));
  }
  bool occluded(const hw::Ray& ray) const override {
    return tracer_->occluded_by_any(plain(ray.origin), plain(ray.direction), ray.tmax);
  }

 private:
  std::shared_ptr<const ref::Tracer> tracer_;
};

}  // namespace

std::shared_ptr<const LaidDown> lay_down(const StressGeometry& geometry, hw::TreeKind kind) {
  auto laid = std::make_shared<LaidDown>();
  const auto static_count = static_cast<std::uint32_t>(geometry.fixed.triangle_count());
  const Tree fixed_tree = build_tree(geometry.fixed, kind, false, "stress");
  const Tree dynamic_tree = build_tree(geometry.dynamic, kind, true, "stress");
  const LaidGeometry fixed = lay_geometry(geometry.fixed, fixed_tree, 0, laid->image);
  describe(fixed, lay_geometry(geometry.dynamic, dynamic_tree, static_count, laid->image), laid->frame);
  return laid;
}

SubjectPointer brute_force(const std::vector<Corners>& triangles, const hw::HitTests& tests) {
  return std::make_unique<BruteForce>(triangles, tests);
}

SubjectPointer walker(std::string name, std::shared_ptr<const LaidDown> laid, const hw::HitTests& tests) {
  return std::make_unique<Walker>(std::move(name), std::move(laid), tests);
}

SubjectPointer golden_traversal(const std::shared_ptr<const ref::Tracer>& tracer) {
  return std::make_unique<GoldenTraversal>(tracer, ref::Extent(), tracer, false);
}

SubjectPointer golden_traversal(std::shared_ptr<const ref::Tracer> near, const ref::Extent& origins,
                                std::shared_ptr<const ref::Tracer> far, bool far_is_slow) {
  return std::make_unique<GoldenTraversal>(std::move(near), origins, std::move(far), far_is_slow);
}

SubjectPointer golden_brute_force(std::shared_ptr<const ref::Tracer> tracer) {
  return std::make_unique<GoldenBruteForce>(std::move(tracer));
}

}  // namespace artu::sim
