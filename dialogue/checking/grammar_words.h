// The words of grammar, which are few and closed, by what they do; and some nouns and adjectives that rules name.
//
// Thread: pure functions.  Cost: one comparison a word of the table.
#pragma once

#include <string_view>

namespace fulcrum::dialogue {

[[nodiscard]] bool is_closed_word(std::string_view word);
/// a, an, the, this, my, each, some, …
[[nodiscard]] bool is_determiner(std::string_view word);
/// a, an, the, my, your, … : never two of them
[[nodiscard]] bool is_central_determiner(std::string_view word);
[[nodiscard]] bool is_possessive(std::string_view word);
/// he, she, it
[[nodiscard]] bool is_third_singular(std::string_view word);
/// I, you, we, they
[[nodiscard]] bool is_other_person(std::string_view word);
/// can, will, must, …
[[nodiscard]] bool is_modal(std::string_view word);
[[nodiscard]] bool is_question_word(std::string_view word);
/// feels, looks, sounds, …: an adjective follows
[[nodiscard]] bool is_linking_verb(std::string_view base);
/// put, cut, hit: the same in the past as in the present
[[nodiscard]] bool is_same_in_past(std::string_view base);
/// think, say, know: "that" or a whole clause follows
[[nodiscard]] bool is_telling_verb(std::string_view word);
/// advice, information: never a or an, never a plural
[[nodiscard]] bool is_strictly_mass(std::string_view noun);
/// metal, wood: what one touches, and things are made of
[[nodiscard]] bool is_material(std::string_view noun);
/// team, family: singular or plural
[[nodiscard]] bool is_collective(std::string_view noun);
/// heavy, rough, red: what is felt or seen of a thing
[[nodiscard]] bool is_physical(std::string_view adjective);
/// today, day, year: an amount or a time, no thing
[[nodiscard]] bool is_time_or_amount(std::string_view noun);
[[nodiscard]] bool is_month_or_day(std::string_view noun);
[[nodiscard]] bool is_planet(std::string_view word);
/// Lift, drag, weight: what is measured, said with an article or without.
[[nodiscard]] bool is_measured(std::string_view word);
/// also, very, always: may stand between subject and verb or before an adjective
[[nodiscard]] bool is_light_adverb(std::string_view word);

}  // namespace fulcrum::dialogue
