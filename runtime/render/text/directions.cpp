#include "runtime/render/text/directions.h"

#include <algorithm>
#include <array>
#include <fribidi.h>
#include <numeric>
#include <utility>

namespace fulcrum::runtime {

namespace {

/// Blocks that hold letters from right to left.
bool may_turn(char32_t c) {
    constexpr std::array<std::pair<char32_t, char32_t>, 5> kBlocks{{{0x590, 0x8FF},
                                                                    {0xFB1D, 0xFDFF},
                                                                    {0xFE70, 0xFEFF},
                                                                    {0x10800, 0x10FFF},
                                                                    {0x1E800, 0x1EFFF}}};
    return c >= 0x590 && std::any_of(kBlocks.begin(), kBlocks.end(), [c](const auto& block) {
               return c >= block.first && c <= block.second;
           });
}

}  // namespace

Directions find_directions(std::u32string_view text) {
    Directions directions;
    directions.levels.assign(text.size(), 0);
    if (std::none_of(text.begin(), text.end(), may_turn)) {
        return directions;
    }
    const auto length = static_cast<FriBidiStrIndex>(text.size());
    const std::vector<FriBidiChar> characters(text.begin(), text.end());
    std::vector<FriBidiCharType> types(text.size());
    std::vector<FriBidiBracketType> brackets(text.size());
    std::vector<FriBidiLevel> levels(text.size());
    fribidi_get_bidi_types(characters.data(), length, types.data());
    fribidi_get_bracket_types(characters.data(), length, types.data(), brackets.data());
    FriBidiParType base = FRIBIDI_PAR_ON;
    if (fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), length, &base,
                                            levels.data()) == 0) {
        return directions;  // no memory: as it is written
    }
    std::transform(levels.begin(), levels.end(), directions.levels.begin(),
                   [](FriBidiLevel level) { return static_cast<std::uint8_t>(level); });
    directions.base = FRIBIDI_IS_RTL(base) ? 1 : 0;
    return directions;
}

std::vector<std::size_t> order_in_line(const std::vector<std::uint8_t>& levels) {
    std::vector<std::size_t> order(levels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto highest = std::max_element(levels.begin(), levels.end());
    // From the deepest level down to 1: whatever is at least so deep is turned round.
    for (std::uint8_t level = highest == levels.end() ? 0 : *highest; level > 0; --level) {
        for (std::size_t i = 0; i < levels.size();) {
            std::size_t end = i;
            while (end < levels.size() && levels[end] >= level) {
                ++end;
            }
            std::reverse(order.begin() + static_cast<long>(i),
                         order.begin() + static_cast<long>(end));
            i = std::max(end, i + 1);
        }
    }
    return order;
}

}  // namespace fulcrum::runtime
