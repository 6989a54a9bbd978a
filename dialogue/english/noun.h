// Nouns: number, plural, mass nouns, proper names, and the article each asks for.
//
//   plural      -s; -es after s x z ch sh; consonant + y -> -ies; f(e) -> -ves and -o -> -oes by table; irregular by table
//   article     by sound, not by letter: a uniform, an hour, an egg, an X-ray, an 8
//   no noun     a number, a place (far) and what begins with a preposition (to the left) take no article at all
//   class       count nouns need a determiner in the singular (a watermelon), mass nouns (water), plurals (apples) and
//               names (Jupiter) don't; some names carry "the" (the Moon)
//
// Thread: pure functions.  Cost: a few table look-ups; at load.
// Source: Quirk, Greenbaum, Leech and Svartvik 1985, "A Comprehensive Grammar of the English Language", chapter 5
//   (nouns and determiners); Huddleston and Pullum 2002, "The Cambridge Grammar of the English Language", chapters 5, 18.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// Grammatical number as the verb sees it.
enum class Number : std::uint8_t { singular, plural };

/// What kind of noun phrase a noun makes.
enum class NounClass : std::uint8_t {
    count,        ///< a watermelon
    mass,         ///< water; the verb is singular
    plural,       ///< scissors, apples; the verb is plural
    name,         ///< Jupiter
    named_the,    ///< the Moon
    name_or_the,  ///< Earth, the Earth
    no_noun       ///< far, to the left, two: never with an article
};

/// A noun of a list, understood.
struct Noun {
    std::string text;  ///< as it is shown, without article: "watermelon", "Moon", "big apple"
    NounClass noun_class = NounClass::count;

    /// The number that the verb agrees with.
    [[nodiscard]] Number number() const {
        return noun_class == NounClass::plural ? Number::plural : Number::singular;
    }
};

/// True for what is around everybody, and so one that all know of: "the wind", "the weather".
[[nodiscard]] bool is_around(std::string_view noun);

/// True for adjectives that stand alone in lists, "heavy", "red": no nouns where no noun follows and no article was asked for.
[[nodiscard]] bool describes(std::string_view word);

/// The adjective of which `word` is the comparative, "long" of "longer"; empty where it is none of those that describe.
[[nodiscard]] std::string compared_of(std::string_view word);

/// Understands a list's entry: "watermelon", "an egg", "the Moon", "Jupiter" (a capital makes a name, as digits do), "water", "scissors".
[[nodiscard]] Noun understand_noun(std::string_view entry);

/// "a" or "an" before `phrase` by the sound of its first word; empty for an empty phrase. Capital letters matter: "an SUV".
[[nodiscard]] std::string_view indefinite_article(std::string_view phrase);

/// True when both are heard before `phrase`: a herb (British), an herb (American); a historic, an historic.
[[nodiscard]] bool both_articles(std::string_view phrase);

/// The plural of the head of `noun`: "box" -> "boxes", "big foot" -> "big feet", "pair of scissors" -> "pairs of scissors".
[[nodiscard]] std::string plural_of(std::string_view noun);

/// The singular of a plural: "windows" -> "window", "feet" -> "foot", "scissors" -> "scissor", which nobody should say
/// (`is_plural_only`). Empty when `noun` isn't plural or its singular is another word: "glasses", "clothes".
[[nodiscard]] std::string singular_of(std::string_view noun);

/// True for nouns that have no singular: "scissors", "trousers".
[[nodiscard]] bool is_plural_only(std::string_view noun);

/// True when the head of the phrase looks plural ("apples", "feet", "scissors"; not "glass", "bus", "Mars").
[[nodiscard]] bool looks_plural(std::string_view noun);

/// True for nouns without a plural ("water", "wood", "advice").
[[nodiscard]] bool is_mass_noun(std::string_view noun);

/// True for the names of forces, which count nothing where a list asks which one it is: "lift", "the lift", never "a lift".
[[nodiscard]] bool names_force(std::string_view noun);

/// True for mass nouns whose plural means kinds of them: "metals", "cheeses"; not "woods", "glasses".
[[nodiscard]] bool has_kinds(std::string_view noun);

/// Wrong plurals that learners make: "foots", "mans", "boxs", "citys", "mices". None is the right one.
[[nodiscard]] std::vector<std::string> learner_plurals(std::string_view noun);

}  // namespace fulcrum::dialogue
