// Names of keys, as lessons and the program know them.
#pragma once

#include <string>

namespace fulcrum::runtime {

/// Name of a GLFW key ("space", "return", "left", "a"); `layout_name` is what stands on the key in
/// the user's layout, may be null. Empty for a key without a name.
[[nodiscard]] std::string key_name(int glfw_key, const char* layout_name);

}  // namespace fulcrum::runtime
