// Which point of grammar an error of form belongs to, as a teacher would name it: codes tell what was done to a word, points
// tell what to practise. A missing "is" is a point of the passive in "a spaceship made of metal", of the verb elsewhere.
//
// Thread: pure functions.  Cost: a few comparisons.
#pragma once

#include "dialogue/marking/mark.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fulcrum::dialogue {

/// A point of grammar.
enum class GrammarPoint : std::uint8_t {
    article,        ///< a, an, the, or none
    adjective,      ///< the plain adjective: hard, not hardly
    comparison,     ///< heavier, the heaviest, and than
    joining,        ///< and
    agreement,      ///< is, are
    passive_voice,  ///< is made of
    verb,           ///< any other verb
    noun_number,    ///< one, many, and what can't be counted
    preposition,
    pronoun,
    wording,  ///< the whole sentence: the order of its words
    spelling
};

inline constexpr std::array<std::string_view, 12> kGrammarPointIds = {
    "article", "adjective",   "comparison",  "joining", "agreement", "passive_voice",
    "verb",    "noun_number", "preposition", "pronoun", "wording",   "spelling"};

/// The point that `error` belongs to; its code isn't `none`.
[[nodiscard]] GrammarPoint grammar_point(const FormError& error);

/// Its name for files and databases, "passive_voice"; the catalogue's key is "point." and this.
[[nodiscard]] constexpr std::string_view grammar_point_id(GrammarPoint point) {
    return kGrammarPointIds[static_cast<std::size_t>(point)];
}

}  // namespace fulcrum::dialogue
