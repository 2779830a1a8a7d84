#include "sim/driver/visit_histogram.h"

#include "hw/functional/render.h"

namespace artu::sim {
namespace {

class VisitTap : public hw::NoTap {
 public:
  void ray(hw::RayKind kind) {
    end_of_ray();
    kind_ = static_cast<std::size_t>(kind);
    open_ = true;
  }
  void node(hw::Address, hw::TreeKind) { ++visits_; }
  void end_of_pixel() { end_of_ray(); }
  VisitHistogram take() { return std::move(histogram_); }

 private:
  void end_of_ray() {
    if (open_) {
      std::vector<std::uint64_t>& rays = histogram_[kind_];
      if (rays.size() <= visits_) rays.resize(visits_ + 1);
      ++rays[visits_];
    }
    open_ = false;
    visits_ = 0;
  }

  VisitHistogram histogram_;
  std::size_t kind_ = 0, visits_ = 0;
  bool open_ = false;
};

}  // namespace

VisitHistogram count_visits(const hw::UnitConfig& unit, hw::MemoryImage& image, hw::Address descriptor,
                            std::uint32_t stack_needed, std::size_t pixels) {
  VisitTap tap;
  hw::PixelRecords records(pixels);
  hw::FunctionalUnit(unit, image).run(descriptor, stack_needed, records, tap);
  return tap.take();
}

}  // namespace artu::sim
