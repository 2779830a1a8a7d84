// What a frame must hold to: checked by the reader on every trace and by the importers before they write.
#pragma once

#include <string>

#include "traces/frame.h"

namespace artu::traces {

/// Largest magnitude of a coordinate (exclusive): beyond it the arithmetic contract makes no promise.
inline constexpr float coordinate_limit = 4611686018427387904.0f;  // 2^62

/// Throws InputError(where, ...) naming the field, its index, its value and the range that is allowed.
/// Refused: non-finite numbers, coordinates at or over coordinate_limit, |uv| over 2^20, negative
/// weights, indices out of range, arrays of unequal length, sizes and enumerations out of range,
/// light directions that are not unit length within 1e-3, names that are not UTF-8 text without control
/// characters, more of anything than limits.h allows.
void validate(const Scene& scene, const std::string& where);
void validate(const Scene& scene, const Frame& frame, const std::string& where);

}  // namespace artu::traces
