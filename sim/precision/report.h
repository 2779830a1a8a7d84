// A sweep's outcome as text, CSV and JSON, and its pictures.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/precision/sweep.h"
#include "sim/report/manifest.h"

namespace artu::sim {

/// Of precision.json's layout: changes when a name that exists changes its meaning or goes.
inline constexpr int precision_schema = 1;

/// A row a tree and format, at most 120 columns; counts are per frame.
std::string format_table(const std::vector<SweepRow>& rows, std::uint32_t frames);

/// A line a tree and format under a line of names; counts are sums over the frames.  "inf" is a PSNR of equal pictures,
/// "nan" an SSIM of pictures that are too small for one.
std::string format_csv(const std::vector<SweepRow>& rows);

/// The same with what was run; what is infinite or no number is null.
std::string format_json(const std::vector<SweepRow>& rows, const SweepPlan& plan, const Manifest& manifest);

/// A format in a file's name: "M07", "M12-15-10".
std::string file_name(const std::string& picture_name);

}  // namespace artu::sim
