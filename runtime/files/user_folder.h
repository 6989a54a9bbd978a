// The folders of the user whose program runs, where the XDG Base Directory Specification puts them, and how they are made so that
// nobody else reads them and no power cut takes them away.
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"

#include <filesystem>

namespace fulcrum::runtime {

/// What the environment's `variable` names, if that is absolute; else `below_home` in the home folder. Nothing is made. Refuses when
/// neither is known; `what_to_do` is the error's advice then.
[[nodiscard]] Expected<std::filesystem::path> find_user_folder(const char* variable,
                                                               const char* below_home,
                                                               const char* what_to_do);

/// Makes the folder and those above it that are missing (mode 0700), and syncs each that got a new entry.
[[nodiscard]] Expected<void> create_private_folders(const std::filesystem::path& folder,
                                                    const char* what_to_do);

/// A new entry is only certain after its folder is synced. Folders that can't be opened for reading are left to the system: their
/// entries are synced with the file on the usual file systems.
void sync_folder(const std::filesystem::path& folder);

}  // namespace fulcrum::runtime
