// The grammar-aware parts of a template: what may be said at a noun, an adjective, a verb, a preposition, an article,
// right and wrong, as arcs of the graph.
//
// Errors are only what English is certain about: "the watermelon" is right where the template says "a {thing}";
// "a apple" and "watermelon is" are not.
//
// Thread: one.  Cost: arcs proportional to the list or to the forms of the word.
#pragma once

#include "dialogue/template/arc_writer.h"
#include "dialogue/template/article_writer.h"

#include <string_view>

namespace fulcrum::dialogue {

/// What is known of the number of a subject that is plain words: "the scissors", "they"; behind "the" it may be a name, "the Earth".
enum class SubjectNumber : std::uint8_t { unknown, singular, plural, name };

/// What stands around a part in its sequence.
struct Neighbours {
    bool after_article = false;
    bool after_list = false;
    bool behind_is = false;         ///< right after the verb "is"
    bool after_no = false;          ///< right after "no", "any", "enough" and their like
    bool in_phrase = false;         ///< after a determiner, with nothing but adjectives between
    bool after_adjective = false;   ///< after <adjective:…> in any degree
    bool before_adjective = false;  ///< before one: "and" joins two, "feels like hard" is wrong
    SubjectNumber subject = SubjectNumber::unknown;  ///< of the word before
    SubjectNumber noun =
        SubjectNumber::unknown;  ///< of the plain noun that an article stands before
    bool after_it = false;       ///< after <it>
    bool closes = false;         ///< last of its phrase: the sentence's end or a verb comes next
    bool before_than = false;    ///< before "than", in brackets or not
    bool begins_phrase =
        true;  ///< at the start or behind a preposition: a noun here has no article before it
};

/// "Red", "blue": all words of the list are adjectives, for a noun to follow.
[[nodiscard]] bool all_describe(const WordList& list);

/// "a watermelon": the article by the noun's class and sound, then the noun, in singular or plural. `behind_is` one thing is
/// meant: "it is eggs" is wrong.
void add_noun_phrase(ArcWriter& writer, const WordList& list, int slot, ArticlePolicy policy,
                     int from, int to, bool behind_is = false);

/// <adjective:hard>, <comparative:heavy>, <superlative:heavy>: one of `words`, which fills `slot` unless that is kNone;
/// `after_article` when the template has "the" before it.
void add_degree(ArcWriter& writer, const WordList& words, int slot, Degree degree,
                bool after_article, int from, int to);

/// Whether "the heaviest one" may be said for "the heaviest".
enum class OneToo : std::uint8_t { no, yes };

/// "One", "of all", "of the three" behind a superlative that ends at `from`, rightly; the node behind it.
int add_of_all(ArcWriter& writer, OneToo one, int from);

/// "Is" behind "than the egg" that ends at `from`, rightly; the node behind it.
int add_than_is(ArcWriter& writer, int from);

/// What was felt a moment ago may be told so: "the apple was the heaviest" where the template has `present`, is or are.
/// `is_either`: the subject settles which of was and were is right (resolve.h).
void add_past_of_be(ArcWriter& writer, Element element, std::string_view present, bool is_either,
                    int from, int to);

/// "Is" between a comparative that ends at `from` and "than", where it belongs before the comparative; the node behind it.
int add_late_is(ArcWriter& writer, int from);

/// What may be said for "is made of metal": in `whole` each word may be wrong but "made" is there; `late` also "is of metal made"; `plain`
/// also "is metal", which is as good, and which behind <it> has a short answer of its own.
enum class Making : std::uint8_t { whole, late, plain };

/// "is made of", "are made of" after the subject; the node behind it.
int add_made_of(ArcWriter& writer, Neighbours near, Making making, int from);

/// "Made" behind the material that ends at `from`, where it belongs before that; the node behind it.
int add_made_last(ArcWriter& writer, int from);

/// What something is made of: one of `words` without an article, which fills `slot` unless that is kNone.
void add_material(ArcWriter& writer, const WordList& words, int slot, int from, int to);

/// <it>: it, this, that, they, these, those; the verb behind it agrees. Of what is known to be one thing "they" is wrong, of several "it".
void add_it(ArcWriter& writer, SubjectNumber number, int from, int to);

/// Lets "it" or "they" repeat the subject that ends at `from`, as an error; the node behind it.
int add_repeated_subject(ArcWriter& writer, int from);

/// <plural:moon>; right behind a number (`after_list`) it may be left out: "there are two".
void add_plural(ArcWriter& writer, std::string_view noun, bool after_list, int from, int to);

/// All of a kind, "apples", where the template has `article`, "the" or another, and `noun`; whether that is right is settled in resolve.h.
void add_kind(ArcWriter& writer, std::string_view article, std::string_view noun, int from, int to);

/// <article> or a literal article before plain words; `word` is empty for <article>. Before a plain noun of number `noun`
/// "this" or "these" may stand there as well.
void add_article(ArcWriter& writer, std::string_view word, SubjectNumber noun, int from, int to);

/// A literal word: a verb that agrees, a preposition, "and" between adjectives, or any other; `shown` is how a recast
/// writes it. After a list a pronoun that repeats the subject is looked for ("a watermelon it is").
void add_word(ArcWriter& writer, std::string_view word, std::string_view shown, Neighbours near,
              int from, int to);

/// True for a, an, the.
[[nodiscard]] bool is_article(std::string_view word);

/// True for this, that, these, those.
[[nodiscard]] bool is_demonstrative(std::string_view word);

/// True for the prepositions whose confusions are looked for, and "than".
[[nodiscard]] bool is_preposition(std::string_view word);

}  // namespace fulcrum::dialogue
