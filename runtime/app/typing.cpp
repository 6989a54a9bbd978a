#include "runtime/app/typing.h"

#include "dialogue/unicode.h"

namespace fulcrum::runtime {

void TypedLine::add(std::string_view utf8) {
    // One whole character at a time, so that none is ever cut.
    for (std::size_t at = 0; at < utf8.size();) {
        const auto [code, bytes, valid] = dialogue::character_at(utf8, at);
        if (code >= 0x20 && code != 0x7F && text_.size() + bytes <= longest_bytes_) {
            text_ += utf8.substr(at, bytes);
        }
        at += bytes;
    }
}

void TypedLine::backspace() {
    if (!text_.empty()) {
        text_.resize(dialogue::whole_characters(text_, text_.size() - 1).size());
    }
}

bool TypedLine::is_blank() const {
    return text_.find_first_not_of(' ') == std::string::npos;
}

std::optional<std::string> TypedLine::take() {
    if (is_blank()) {
        text_.clear();
        return std::nullopt;
    }
    std::string line = std::move(text_);
    text_.clear();
    return line;
}

}  // namespace fulcrum::runtime
