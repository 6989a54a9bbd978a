// A text with *emphasis*, parted into what is read and where it is strong.
//
// Thread: pure.  Cost: linear in the text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// The text without asterisks, and the byte ranges [begin, end) of it that stood between two of them.
struct MarkedText {
    std::string plain;
    std::vector<std::pair<std::size_t, std::size_t>> strong;
};

/// Parts `text`; an asterisk without a second one stays as it is.
[[nodiscard]] MarkedText part_emphasis(std::string_view text);

}  // namespace fulcrum::dialogue
