#include "runtime/text/terminal_text.h"

#include "runtime/text/utf8.h"

#include <algorithm>
#include <array>

namespace fulcrum::runtime {
namespace {

struct CodePoints {
    char32_t first;
    char32_t last;
};

// Drawn over what stands before them.
constexpr std::array<CodePoints, 5> kCombining{
    {{0x0300, 0x036F}, {0x1AB0, 0x1AFF}, {0x1DC0, 0x1DFF}, {0x20D0, 0x20FF}, {0xFE20, 0xFE2F}}};
// Letters of Korean, Chinese and Japanese, their full-width forms, and pictures.
constexpr std::array<CodePoints, 9> kWide{{{0x1100, 0x115F},
                                           {0x2E80, 0x303E},
                                           {0x3041, 0xA4CF},
                                           {0xAC00, 0xD7A3},
                                           {0xF900, 0xFAFF},
                                           {0xFE30, 0xFE6F},
                                           {0xFF00, 0xFF60},
                                           {0x1F300, 0x1FAFF},
                                           {0x20000, 0x3FFFD}}};

template <std::size_t N>
bool is_in(const std::array<CodePoints, N>& sets, char32_t c) {
    return std::any_of(sets.begin(), sets.end(),
                       [c](const CodePoints& set) { return c >= set.first && c <= set.last; });
}

int columns_of(char32_t c) {
    if (is_in(kCombining, c)) {
        return 0;
    }
    return is_in(kWide, c) ? 2 : 1;
}

}  // namespace

std::string fit_to_columns(std::string_view utf8, int columns) {
    std::string fitting;
    int taken = 0;
    for (const char32_t decoded : decode_for_display(utf8)) {
        const char32_t c = decoded == U'\n' ? U' ' : decoded;
        taken += columns_of(c);
        if (taken > columns) {
            break;
        }
        append_utf8(fitting, c);
    }
    return fitting;
}

}  // namespace fulcrum::runtime
