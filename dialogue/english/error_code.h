// The kinds of error of form that are looked for, with the codes of ERRANT: M missing, R replace, U unnecessary, then
// the part of speech or the operation.
//
// Source: Bryant, Felice and Briscoe 2017, "Automatic Annotation and Evaluation of Error Types for Grammatical Error
// Correction", ACL. Two things are ours: R:PREP also holds a wrong word for "than" after a comparative, and R:VERB:VOICE
// is an active verb where the passive belongs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fulcrum::dialogue {

/// One kind of error of form.
enum class ErrorCode : std::uint8_t {
    none,
    missing_determiner,   ///< M:DET       "watermelon is the heaviest"
    wrong_determiner,     ///< R:DET       "a apple"
    extra_determiner,     ///< U:DET       "a water", "the heavier than"
    adjective_form,       ///< R:ADJ:FORM  "most heavy", "more heavier", "goodest"
    agreement,            ///< R:VERB:SVA  "a watermelon are"
    missing_verb,         ///< M:VERB      "a watermelon the heaviest"
    verb_form,            ///< R:VERB:FORM "a watermelon be"
    verb_tense,           ///< R:VERB:TENSE "the wind stop" for "stopped"
    extra_pronoun,        ///< U:PRON      "a watermelon it is"
    wrong_preposition,    ///< R:PREP      "heavier then", "made by wood"
    missing_preposition,  ///< M:PREP      "heavier an apple"
    wrong_adverb,         ///< R:ADV       "very heavier"
    noun_number,          ///< R:NOUN:NUM  "a watermelons", "two moon"
    noun_inflection,      ///< R:NOUN:INFL "two mans"
    spelling,             ///< R:SPELL     "watermellon", "heavyest"
    orthography,          ///< R:ORTH      "water melon", "its" for "it's"
    missing_pronoun,      ///< M:PRON      "is made of metal"
    morphology,           ///< R:MORPH     "metal is hardly", "metal is hardness"
    missing_conjunction,  ///< M:CONJ      "metal is hard smooth"
    wrong_conjunction,    ///< R:CONJ      "metal is hard or smooth"
    extra_preposition,    ///< U:PREP      "metal feels like hard"
    verb_inflection,      ///< R:VERB:INFL "is maked of"
    wording,     ///< R:OTHER     "how many moons Jupiter has": the whole sentence goes another way
    verb_voice,  ///< R:VERB:VOICE "a spaceship makes of metal"
    word_order,  ///< R:WO       "a rock hard", "what it is?"
    wrong_pronoun,  ///< R:PRON  "they are made of metal" of one thing
};

inline constexpr int kErrorCodes = 27;

/// The code as ERRANT writes it, e.g. "R:ADJ:FORM"; empty for `none`.
[[nodiscard]] constexpr std::string_view errant_code(ErrorCode code) {
    constexpr std::string_view kNames[kErrorCodes] = {
        "",           "M:DET",  "R:DET",       "U:DET",        "R:ADJ:FORM",
        "R:VERB:SVA", "M:VERB", "R:VERB:FORM", "R:VERB:TENSE", "U:PRON",
        "R:PREP",     "M:PREP", "R:ADV",       "R:NOUN:NUM",   "R:NOUN:INFL",
        "R:SPELL",    "R:ORTH", "M:PRON",      "R:MORPH",      "M:CONJ",
        "R:CONJ",     "U:PREP", "R:VERB:INFL", "R:OTHER",      "R:VERB:VOICE",
        "R:WO",       "R:PRON"};
    return kNames[static_cast<std::size_t>(code)];
}

}  // namespace fulcrum::dialogue
