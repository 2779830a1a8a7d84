// Scene files, read as `artu import` does: everything that a file can make the importer do.
#pragma once

#include <string>

namespace artu::fuzz {

/// Opens the scene and poses it at two frames.
void import_scene(const std::string& path);

}  // namespace artu::fuzz
