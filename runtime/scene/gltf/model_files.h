// The files that a model may name: plain names in its own folder, nothing else.
#pragma once

#include "haptics/base/error.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime::gltf {

using Bytes = std::vector<std::byte>;

/// Decodes %xx and refuses what is not a plain file name: empty, ".", "..", with a slash, a
/// backslash, a colon (schemes, drives) or a control character.
[[nodiscard]] Expected<std::string> plain_file_name(std::string_view uri);

/// Reads a regular file whole. With `follow_links` false the last part of the path may not be a
/// symbolic link. Refuses folders, devices and pipes, and more than `limit_bytes`.
[[nodiscard]] Expected<Bytes> read_regular_file(const std::filesystem::path& path,
                                                std::size_t limit_bytes, bool follow_links);

}  // namespace fulcrum::runtime::gltf
