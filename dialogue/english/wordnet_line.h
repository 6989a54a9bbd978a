// The lines of WordNet's files: fields apart by blanks, numbers in decimal or hexadecimal (wndb(5WN)).
//
// Thread: any.  Cost: none but the reading.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string_view>

namespace fulcrum::dialogue {

/// Takes the next field off `line`; empty at its end, and between two blanks.
inline std::string_view take_field(std::string_view& line) {
    const std::size_t end = std::min(line.find(' '), line.size());
    const std::string_view field = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    return field;
}

/// A field as a number; 0 where it is none.
inline std::size_t number_in(std::string_view field, int base) {
    std::size_t number = 0;
    std::from_chars(field.data(), field.data() + field.size(), number, base);
    return number;
}

}  // namespace fulcrum::dialogue
