// Comparison of adjectives: heavy, heavier, the heaviest; beautiful, more beautiful, the most beautiful.
//
//   one syllable                -er -est     big bigger biggest, large larger largest, dry drier driest
//   two syllables in -y         -ier -iest   heavy heavier heaviest
//   -er -le -ow and some others both         clever cleverer / more clever; simple, narrow, quiet
//   all others                  more most    famous, beautiful, tired, fun
//   irregular                   a table      good better best; bad, far, little, many, much
//
// Spelling of the ending: a final e is not doubled; consonant + y becomes i; one vowel letter + one consonant letter
// (not w, x, y) in a word of one syllable doubles the consonant.
//
// Thread: pure functions.  Cost: a few table look-ups; at load.
// Source: Quirk, Greenbaum, Leech and Svartvik 1985, "A Comprehensive Grammar of the English Language", chapter 7
//   (comparison of adjectives); Huddleston and Pullum 2002, "The Cambridge Grammar of the English Language", chapter 18
//   (inflectional morphology).
#pragma once

#include "dialogue/english/error_code.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// The degree of an adjective.
enum class Degree : std::uint8_t { positive, comparative, superlative };

/// How an adjective makes its degrees, as a rule tells a pupil.
enum class Comparison : std::uint8_t { ending, more_most, both, irregular };

/// How `adjective` (lower case) is compared.
[[nodiscard]] Comparison comparison_of(std::string_view adjective);

/// All forms that English accepts, the one to teach first, without "the": {"heavier"}, {"quieter", "more quiet"},
/// {"more beautiful"}. `positive` gives the adjective itself. Never empty for a non-empty word.
[[nodiscard]] std::vector<std::string> degree_forms(std::string_view adjective, Degree degree);

/// `adjective` + "er" or "est" by the rules of spelling alone, whether English says so or not: "beautifuler".
[[nodiscard]] std::string with_ending(std::string_view adjective, std::string_view ending);

/// Number of syllables, counted from the letters; right for common adjectives, a guess for others. At least 1.
[[nodiscard]] int syllables(std::string_view word);

/// A form that learners say instead of the right one, and what kind of error it is.
struct LearnerForm {
    std::string text;  ///< lower case, words apart by one space
    ErrorCode code = ErrorCode::none;
    int slip = 1;  ///< how far from the right form: 1 a slip, 2 a wrong pattern, 3 another degree
};

/// The labelled wrong forms of `adjective` in `degree`. Superlative: "most heavy", "most heaviest", "heavyest", "heavier",
/// "heavy". Positive: another kind of word, "hardly", "hardness", "hardy", "stick" for sticky; another degree, "harder", "more hard".
/// None of them is an accepted form, none appears twice.
[[nodiscard]] std::vector<LearnerForm> learner_forms(std::string_view adjective, Degree degree);

}  // namespace fulcrum::dialogue
