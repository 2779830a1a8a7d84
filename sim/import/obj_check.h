// What tinyobjloader would let pass: numbers that are none, read as 0, and indices that are none or wrap around.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace artu::sim {

/// The text without the mark that some editors put before UTF-8; tinyobjloader would skip its line.
std::string_view without_byte_order_mark(std::string_view text);

/// Throws InputError with file and line if a v, vt or vn line of the OBJ text has too few numbers, or something that
/// is no finite number; or if an f line has fewer than three corners, or one that is not there.  Returns how many
/// triangles its faces are.
std::uint64_t check_obj(std::string_view text, const std::string& path);

}  // namespace artu::sim
