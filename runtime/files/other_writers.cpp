#include "runtime/files/other_writers.h"

#include <system_error>

namespace fulcrum::runtime {

bool may_others_write(const struct stat& about) noexcept {
    const bool has_own_group = about.st_gid == about.st_uid;
    return (about.st_mode & S_IWOTH) != 0 || (!has_own_group && (about.st_mode & S_IWGRP) != 0);
}

std::optional<std::string> find_other_writers(const std::filesystem::path& file) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(file, error);
    struct stat about {};
    if (error || ::stat(real.c_str(), &about) != 0) {
        return std::nullopt;
    }
    if (may_others_write(about)) {
        return "others may write to this file";
    }
    if (::stat(real.parent_path().c_str(), &about) == 0 && may_others_write(about) &&
        (about.st_mode & S_ISVTX) == 0) {
        return "others may write to the folder of this file";
    }
    return std::nullopt;
}

std::optional<std::filesystem::path> find_dangling_link(const std::filesystem::path& file) {
    std::filesystem::path way;
    for (const std::filesystem::path& part : file) {
        way /= part;
        std::error_code error;
        if (std::filesystem::exists(way, error) || error) {
            continue;
        }
        return std::filesystem::is_symlink(way, error) ? std::optional(way) : std::nullopt;
    }
    return std::nullopt;
}

}  // namespace fulcrum::runtime
