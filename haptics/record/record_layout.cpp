#include "haptics/record/record_layout.h"

#include <algorithm>

namespace fulcrum::record_layout {
namespace {

bool is_control(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

}  // namespace

void Sink::text(std::string_view text) {
    // A UTF-8 character's later bytes are 10xxxxxx; do not cut before one of them.
    std::size_t length = std::min(text.size(), kRecordTextBytes);
    while (length > 0 && length < text.size() &&
           (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
        --length;
    }
    field(static_cast<std::uint32_t>(length));
    for (const char c : text.substr(0, length)) {
        bytes_.push_back(static_cast<std::byte>(is_control(c) ? ' ' : c));
    }
}

std::string Source::padded_text(std::size_t size) {
    std::string text;
    for (std::size_t i = 0; i < size && bytes_[i] != std::byte{0}; ++i) {
        text.push_back(static_cast<char>(bytes_[i]));
    }
    bytes_ = bytes_.subspan(size);
    return text;
}

bool Source::text(std::string& text) {
    std::uint32_t size = 0;
    if (!has(sizeof size)) {
        return false;
    }
    field(size);
    if (size > kRecordTextBytes || !has(size)) {
        return false;
    }
    text.assign(reinterpret_cast<const char*>(bytes_.data()), size);
    bytes_ = bytes_.subspan(size);
    return true;
}

bool is_printable(const std::string& text) {
    return std::none_of(text.begin(), text.end(), is_control);
}

}  // namespace fulcrum::record_layout
