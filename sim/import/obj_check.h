// What tinyobjloader would let pass: numbers that are none, read as 0.
#pragma once

#include <string>
#include <string_view>

namespace artu::sim {

/// Throws InputError with file and line if a v, vt or vn line of the OBJ text has too few numbers, or something that
/// is no finite number.
void check_obj_numbers(std::string_view text, const std::string& path);

}  // namespace artu::sim
