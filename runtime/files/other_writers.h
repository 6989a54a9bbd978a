// The one rule for a file that another user's hand must not change: limits of this place, learners' progress, a key, a cache.
//
//   mode    neither the file nor the folder in which it really lies, links followed, may be written by others: by everybody, or by a
//           group that is not the owner's own (Debian gives each user one of the user's number). In a folder with the sticky bit
//           nobody replaces what is another's
//
// Thread: load.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/stat.h>

namespace fulcrum::runtime {

/// Whether others than the owner may write to what `about` tells of.
[[nodiscard]] bool may_others_write(const struct stat& about) noexcept;

/// "others may write to this file" or "… to the folder of this file"; nothing where neither is so, or there is no such file.
[[nodiscard]] std::optional<std::string> find_other_writers(const std::filesystem::path& file);

/// Of a path that leads nowhere the link that does: the file, or a folder on the way, is a link to what is not there. Nothing where
/// the file is there, or where nothing on the way is a link.
[[nodiscard]] std::optional<std::filesystem::path> find_dangling_link(
    const std::filesystem::path& file);

}  // namespace fulcrum::runtime
