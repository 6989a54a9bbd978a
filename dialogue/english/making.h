// The passive of "make": what things are made of.
//
//   is made of       the material is still there: a table is made of wood
//   is made from     it was changed in the making: paper is made from wood
//   made             make, made, made; learners say make, maked, making
//
// Thread: pure functions.  Cost: a table look-up; at load, and once an answer.
// Source: Quirk, Greenbaum, Leech and Svartvik 1985, "A Comprehensive Grammar of the English Language", chapter 3
//   (voice) and chapter 9 (prepositions of ingredient and material: of, out of, from).
#pragma once

#include "dialogue/english/verb.h"

#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// What learners say for the participle "made": "make" R:VERB:FORM, "maked" R:VERB:INFL, "maid" R:SPELL.
[[nodiscard]] std::vector<LearnerVerb> learner_participles();

/// What learners say for the "is" of "is made", apart from its numbers: "has", "be", "was".
[[nodiscard]] std::vector<LearnerVerb> learner_auxiliaries();

/// Active forms that learners say for "is made": "makes", "make".
[[nodiscard]] std::vector<LearnerVerb> active_for_passive();

/// True when `material` is no longer there in `thing`, so that "made from" is right: paper from wood, glass from sand.
/// Both in singular or plural, any case; the last words count.
[[nodiscard]] bool changed_in_making(std::string_view thing, std::string_view material);

}  // namespace fulcrum::dialogue
