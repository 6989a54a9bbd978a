#include "dialogue/english/determiner.h"

#include "dialogue/english/word_table.h"

#include <array>

namespace fulcrum::dialogue {

bool is_sole_determiner(std::string_view word) {
    constexpr std::array<std::string_view, 13> kDeterminers = {
        "a",  "an",   "the", "this", "that", "these", "those",
        "my", "your", "our", "its",  "his",  "their"};
    return contains(kDeterminers, word);
}

}  // namespace fulcrum::dialogue
