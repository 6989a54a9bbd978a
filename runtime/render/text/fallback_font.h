// The installed font that has a character which the program's own fonts lack, as fontconfig knows it.
//
// Thread: one. Cost: the first call reads fontconfig's settings and its list of fonts (tens of
// milliseconds), later ones take about one; nothing is read before the first call.
// Source: fontconfig 2.14 developers' reference, "FcFontMatch".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// A face in a file of fonts.
struct FontFile {
    std::string path;
    int index = 0;
};

/// An outline font that has all of these characters; none where no font on this machine has.
[[nodiscard]] std::optional<FontFile> find_font_with(std::u32string_view characters, bool bold);

}  // namespace fulcrum::runtime
