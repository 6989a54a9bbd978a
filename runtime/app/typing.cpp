#include "runtime/app/typing.h"

namespace fulcrum::runtime {
namespace {

bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}
bool is_control(char c) {
    return static_cast<unsigned char>(c) < 0x20U || c == 0x7F;
}

}  // namespace

void TypedLine::add(std::string_view utf8) {
    for (std::size_t at = 0; at < utf8.size();) {
        // One whole character at a time, so that none is ever cut.
        std::size_t end = at + 1;
        while (end < utf8.size() && is_continuation(utf8[end])) {
            ++end;
        }
        const std::string_view character = utf8.substr(at, end - at);
        if (!is_control(character.front()) && text_.size() + character.size() <= longest_bytes_) {
            text_ += character;
        }
        at = end;
    }
}

void TypedLine::backspace() {
    while (!text_.empty() && is_continuation(text_.back())) {
        text_.pop_back();
    }
    if (!text_.empty()) {
        text_.pop_back();
    }
}

std::optional<std::string> TypedLine::take() {
    if (text_.find_first_not_of(' ') == std::string::npos) {
        text_.clear();
        return std::nullopt;
    }
    std::string line = std::move(text_);
    text_.clear();
    return line;
}

}  // namespace fulcrum::runtime
