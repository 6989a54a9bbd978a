// What stands around a part of a template's tree, for the graph that is written of it.
//
// Thread: pure.  Cost: linear in the part.
#pragma once

#include "dialogue/template/syntax.h"

#include <cstddef>

namespace fulcrum::dialogue {

/// A part by its index, which must be one of the tree's.
[[nodiscard]] inline const SyntaxNode& part_at(const Syntax& syntax, int index) {
    return syntax[static_cast<std::size_t>(index)];
}

/// The part itself, without brackets and sequences that hold nothing else.
[[nodiscard]] const SyntaxNode& unwrapped(const Syntax& syntax, int index);

/// A plain word that is neither verb, preposition nor determiner.
[[nodiscard]] bool may_be_noun(const SyntaxNode& part);

/// A plain noun with no other noun behind it, no name.
[[nodiscard]] bool is_head_noun(const SyntaxNode& part, const SyntaxNode* next);

/// A determiner, or one of several: "the", "(my|your)", "one"; "that" may be another word.
[[nodiscard]] bool is_determined(const Syntax& syntax, int index);

/// "No", "enough", "(any|too little)": how much, and the noun behind it has no article.
[[nodiscard]] bool takes_no_article(const Syntax& syntax, int index);

/// "[one|object]": a noun that may be said or not.
[[nodiscard]] bool is_optional_noun(const Syntax& syntax, const SyntaxNode* part);

/// Nothing of the phrase comes with `next`: a verb, a preposition that isn't "of", or nothing at all, where `beyond` tells.
[[nodiscard]] bool closes_phrase(const Syntax& syntax, const SyntaxNode* next, bool beyond);

/// `part` is "than", or "[than …]".
[[nodiscard]] bool begins_with_than(const Syntax& syntax, const SyntaxNode* part);

}  // namespace fulcrum::dialogue
