#include "runtime/scene/gltf/json_text.h"

#include "runtime/scene/gltf/limits.h"

#include <cstddef>

namespace fulcrum::runtime::gltf {
namespace {

/// The index of the quote that ends the string which begins at `at`, or the text's length.
std::size_t end_of_string(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\') {
            ++at;
        }
    }
    return at;
}

}  // namespace

Expected<void> check_json_text(std::string_view text) {
    int depth = 0;
    // A value is begun by a bracket, or parted from the one before by a comma; a key by neither.
    std::size_t values = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        switch (text[i]) {
            case '"':
                i = end_of_string(text, i);
                break;
            case '[':
            case '{':
                ++depth;
                ++values;
                break;
            case ']':
            case '}':
                --depth;
                break;
            case ',':
                ++values;
                break;
            default:
                break;
        }
        if (depth > kMaxJsonDepth) {
            return fail("its JSON is nested more than 64 deep", {}, kExportAgain);
        }
        if (values > kMaxJsonValues) {
            return fail("its JSON has more than 250000 values", {},
                        "keep coordinates in buffers and remove extras");
        }
    }
    return {};
}

}  // namespace fulcrum::runtime::gltf
