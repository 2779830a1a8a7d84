// Files that a scene file names: only from inside the scene's own folder.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace artu::sim {

std::string percent_decode(const std::string& uri);

/// The real path of `uri` (already decoded), below `folder`.  Throws InputError(where, ...) for an absolute path, a
/// scheme, `..`, a link that leaves the folder, and what is not a readable regular file.
std::string resource_path(const std::string& folder, const std::string& uri, const std::string& where);

/// The folder of a file, "." if it is in the working folder.
std::string folder_of(const std::string& path);

/// All bytes of a file.  Throws InputError(path, ...) if it cannot be read or is over `limit` bytes.
std::vector<std::uint8_t> read_file(const std::string& path, std::uint64_t limit);

}  // namespace artu::sim
