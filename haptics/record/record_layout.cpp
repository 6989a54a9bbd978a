#include "haptics/record/record_layout.h"

#include <algorithm>

namespace fulcrum::record_layout {

void Sink::text(std::string_view text, std::size_t size) {
    // A UTF-8 character's later bytes are 10xxxxxx; do not cut before one of them.
    std::size_t length = std::min(text.size(), size);
    while (length > 0 && length < text.size() &&
           (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
        --length;
    }
    // What follows a zero could not be read back.
    length = std::min(length, text.find('\0'));
    for (std::size_t i = 0; i < size; ++i) {
        bytes_.push_back(i < length ? static_cast<std::byte>(text[i]) : std::byte{0});
    }
}

std::string Source::text(std::size_t size) {
    std::string text;
    for (std::size_t i = 0; i < size && bytes_[i] != std::byte{0}; ++i) {
        text.push_back(static_cast<char>(bytes_[i]));
    }
    bytes_ = bytes_.subspan(size);
    return text;
}

}  // namespace fulcrum::record_layout
