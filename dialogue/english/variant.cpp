#include "dialogue/english/variant.h"

#include "dialogue/english/letters.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// British, American.
constexpr std::array<std::pair<std::string_view, std::string_view>, 22> kSpellings = {{
    {"tyre", "tire"},
    {"colour", "color"},
    {"grey", "gray"},
    {"metre", "meter"},
    {"litre", "liter"},
    {"centre", "center"},
    {"fibre", "fiber"},
    {"aluminium", "aluminum"},
    {"jewellery", "jewelry"},
    {"mould", "mold"},
    {"doughnut", "donut"},
    {"woollen", "woolen"},
    {"fibreglass", "fiberglass"},
    {"plough", "plow"},
    {"sulphur", "sulfur"},
    {"towards", "toward"},
    {"forwards", "forward"},
    {"backwards", "backward"},
    {"upwards", "upward"},
    {"downwards", "downward"},
    {"inwards", "inward"},
    {"outwards", "outward"},
}};

/// The other spelling of one word, also of its plural in -s; empty when there is none.
std::string other_word(std::string_view word) {
    const bool plural = word.size() > 1 && word.back() == 's';
    const std::string_view stem = plural ? word.substr(0, word.size() - 1) : word;
    for (const auto& [british, american] : kSpellings) {
        if (word == british || word == american) {
            return std::string(word == british ? american : british);
        }
        if (stem == british || stem == american) {
            return std::string(stem == british ? american : british) + (plural ? "s" : "");
        }
    }
    return {};
}

}  // namespace

std::string other_spelling(std::string_view phrase) {
    std::string text = lower_case(phrase);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" -", at), text.size());
        if (const std::string other = other_word(std::string_view(text).substr(at, end - at));
            !other.empty()) {
            return text.replace(at, end - at, other);
        }
        at = end + 1;
    }
    return {};
}

}  // namespace fulcrum::dialogue
