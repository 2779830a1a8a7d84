// Files and folders that are there after the machine has lost its power, not only after the process has ended.
#pragma once

#include <string>
#include <string_view>

namespace artu::sim {

/// Waits until a folder's files, and the folder itself, are on the disk.
void sync_folder(const std::string& folder);

/// Replaces the file as a whole: readers see the old content or the new.
void write_durably(const std::string& name, std::string_view text);

/// Renames a file or folder whose content is on the disk already; false where `to` is a folder that is not empty.
bool rename_durably(const std::string& from, const std::string& to);

}  // namespace artu::sim
