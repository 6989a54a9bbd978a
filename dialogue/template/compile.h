// Compiles the sentence templates of one question into graphs.
//
//   sentences  "[a|an|the] {thing} is the <superlative:heavy> [one|object]"
//   lists      thing = watermelon, apple, an hour, the Moon, Jupiter, "bike|bicycle" (the first is what a recast says)
//   rules      name = a template used as <name>
//   nearly     "how many moons {planet} has": what learners say for it that is no good English
//
// Grammar-aware: an article or a bracket of articles before a {list} asks for the article that the noun needs, and the first
// of a bracket is the one that is said back: "[a|an|the] {thing}" any such thing ("An apple is …", as <article> does),
// "[the|a|an] {thing}" and "the {thing}" the one that is there ("The apple is …"). Verbs agree
// with the noun before them; <superlative:…>, <comparative:…>, <adjective:…>, <made_of:…>, <plural:…>, <article> and <it>
// know their right forms and the wrong ones that learners say; the first four also take any word of a list, <made_of:{material}>. A
// question that a single word answers is given short answers too ("The watermelon.").
//
// Bounded: depth, length, words and arcs; a rule that uses itself is refused.
//
// Thread: pure.  Cost: linear in the arcs, at most kLargestGraph_arcs; at load.
#pragma once

#include "dialogue/result.h"
#include "dialogue/template/graph.h"

#include <string>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// Names with their texts, in the author's order.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;
/// Names with several texts each.
using NamedLists = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// What an author wrote.
struct TemplateSource {
    std::vector<std::string> sentences;
    NamedLists lists;
    NamedTexts rules;
    std::vector<std::string>
        nearly{};  ///< understood, and said back as the first sentence that fits
    /// What each of `sentences` and each of `nearly` is about: the latter are said back as one about the same. Empty: all are
    /// about one thing.
    std::vector<int> subjects{};
    std::vector<int> nearly_subjects{};
};

/// Compiles; an error names the sentence or rule, and its column.
[[nodiscard]] Expected<TemplateSet> compile_templates(const TemplateSource& source);

}  // namespace fulcrum::dialogue
