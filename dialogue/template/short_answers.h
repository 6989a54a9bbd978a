// What a template set is given beside the author's sentences: short answers to them, and the passive turned round.
//
//   "the {thing} is the <superlative:heavy>"        "The watermelon." "It is the watermelon."
//   "{thing} <made_of:{material}>"                  "Metal." "It is metal." "It is made of metal." "Made of metal."
//   "{material} is <adjective:{feel}> [and <…>]"    "Hard and smooth." "It is hard and smooth." "They feel hard."
//   "there are {number} <plural:ramp>"              "Three ramps."
//   "{thing} <made_of:{material}>", turned round    "Metal is made of a spaceship.": understood, and not true
//
// Thread: pure.  Cost: linear in the arcs.
#pragma once

#include "dialogue/result.h"
#include "dialogue/template/graph_builder.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// One sentence, and the slots of grammar in it.
struct BuiltSentence {
    Graph graph;
    FormSlots forms;
};

/// Whether a sentence is also heard with its verb at the end, as an error (word_order.h).
enum class WordOrder : std::uint8_t { right_only, verb_last_too };

/// How many more arcs `set` may have.
[[nodiscard]] std::size_t arcs_left(const TemplateSet& set);

/// True when a right sentence of `graph` may have no word at all.
[[nodiscard]] bool may_be_empty(const Graph& graph);

/// Compiles one sentence of `set`; an error has its column. `pronoun` is the number of what <it> stands for.
[[nodiscard]] Expected<BuiltSentence> build_sentence(TemplateSet& set, const ParsedRules& rules,
                                                     const std::string& text,
                                                     SubjectNumber pronoun = SubjectNumber::unknown,
                                                     WordOrder order = WordOrder::right_only);

/// Adds what is counted alone, "three ramps" of "there are {number} <plural:ramp>"; nothing where the author wrote that, or there is no room.
void add_counted_answers(TemplateSet& set, const ParsedRules& rules,
                         const std::vector<std::string>& sentences);

/// Adds the graphs that `set.answers` sentences ask for; `forms` has the slots of each.
[[nodiscard]] Expected<bool> add_short_answers(TemplateSet& set, const ParsedRules& rules,
                                               const std::vector<FormSlots>& forms);

}  // namespace fulcrum::dialogue
