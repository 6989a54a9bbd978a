// The sentences of variants.h as templates' text, made from the author's own text: "[the] {thing} is <comparative:heavy>" gives
// "[the] {thing} weighs more".
//
// Thread: pure.  Cost: linear in the text.
#pragma once

#include "dialogue/template/graph.h"
#include "dialogue/template/graph_builder.h"

#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// A sentence that follows from an author's.
struct Variant {
    std::string text;
    Claim claim = Claim::same;
    std::string
        about{};  ///< the slot that another claim is about; empty where it is about the whole
    bool is_short = false;  ///< "neither", "not the egg"
};

/// All that follow from `text`, one of `set`'s answers; none where it has no form that is known here.
[[nodiscard]] std::vector<Variant> variants_of(const TemplateSet& set, const ParsedRules& rules,
                                               const std::string& text);

}  // namespace fulcrum::dialogue
