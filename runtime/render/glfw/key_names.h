// Names of keys, as lessons and the program know them.
#pragma once

#include <string>

namespace fulcrum::runtime {

/// Name of a GLFW key ("space", "return", "left", "a"); `layout_name` is what stands on the key in
/// the user's layout, may be null. Empty for a key without a name.
[[nodiscard]] std::string key_name(int glfw_key, const char* layout_name);

/// A code point as UTF-8; empty for one that no text holds.
[[nodiscard]] std::string utf8_of(unsigned int code_point);

}  // namespace fulcrum::runtime
