#include "dialogue/result.h"

namespace fulcrum::dialogue {

tl::unexpected<Error> fail(std::string_view message, int column, int line) {
    return tl::unexpected<Error>(Error{std::string(message), column, line});
}

std::string concat(std::initializer_list<std::string_view> parts) {
    std::string text;
    for (const std::string_view part : parts) {
        text += part;
    }
    return text;
}

}  // namespace fulcrum::dialogue
