#include "sim/report/pixel_csv.h"

#include <fmt/format.h>

#include "sim/report/names.h"

namespace artu::sim {

const char* const pixel_csv_header =
    "frame,x,y,pass,class,n_static,n_dynamic,threshold,difference,decision,r,g,b,primitive,t_bits\n";

std::string pixel_csv_row(std::uint32_t frame, std::uint32_t x, std::uint32_t y, const hw::PixelRecord& p) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", frame, x, y, p.pass, class_name(p.hit_class),
                     p.n_static, p.n_dynamic, p.threshold, p.difference, decision_name(p.decision), p.r, p.g, p.b,
                     p.primitive, p.t_bits);
}

}  // namespace artu::sim
