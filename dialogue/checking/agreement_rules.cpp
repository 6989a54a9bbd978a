// Errors of agreement between subject and verb in a free sentence.
#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/checking/proposal.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/verb.h"

#include <algorithm>
#include <array>
#include <utility>

// Each rule is one chain of conditions, told in the order in which the grammar has them.
// NOLINTBEGIN(readability-function-cognitive-complexity,bugprone-branch-clone)
namespace fulcrum::dialogue {
namespace {

/// Verbs of grammar: with it, with they.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kPairs = {
    {{"is", "are"}, {"was", "were"}, {"has", "have"}, {"does", "do"}}};

/// The form of verb `i` that agrees with `number`; empty when it does, or when it has no number.
std::string agreeing(const FreeSentence& sentence, int i, Number number) {
    const FreeWord& word = sentence[i];
    for (const auto& [one, many] : kPairs) {
        if (word.text == one && number == Number::plural) {
            return std::string(many);
        }
        if (word.text == many && number == Number::singular) {
            return std::string(one);
        }
    }
    if (word.text == "am") {
        return number == Number::plural ? "are" : "is";
    }
    if (word.closed || word.verb.empty() || word.possessive) {
        return {};
    }
    if (number == Number::plural && word.verb_in_s && word.text != word.verb) {
        return word.verb;
    }
    const bool plain = word.verb_plain && !word.verb_in_s && word.text == word.verb;
    if (number == Number::singular && plain && !is_same_in_past(word.verb)) {
        return third_person(word.verb);
    }
    return {};
}

/// The verb of a subject that ends before `i`; small adverbs may stand between.
int verb_behind(const FreeSentence& sentence, int i) {
    while (is_light_adverb(sentence.text(i)) && !sentence.is(i, {"not", "much"}) &&
           !sentence[i].before_stop) {
        ++i;
    }
    return i;
}

/// "When I push the side it turn more": the clause before it has no comma. No verb that could govern a plain one stands anywhere.
bool resumes(const FreeSentence& sentence, int i) {
    constexpr std::array<std::string_view, 15> kGoverning = {
        "do",  "does", "did",  "let",   "lets", "make", "makes", "made",
        "see", "help", "feel", "watch", "not",  "hear", "saw"};
    const FreeWord& before = sentence[i - 1];
    const bool ended = (!before.closed && before.noun_count > before.verb_count) ||
                       sentence.is(i - 1, {"it", "possible"});
    if (i < 2 || !sentence.is(i, {"it"}) || !ended || sentence.asks() ||
        !sentence.is(0, {"when", "if", "near", "at", "on", "more", "far", "as", "close"})) {
        return false;
    }
    for (int at = 0; at < sentence.size(); ++at) {
        if (is_modal(sentence.text(at)) || std::find(kGoverning.begin(), kGoverning.end(),
                                                     sentence.text(at)) != kGoverning.end()) {
            return false;
        }
    }
    return true;
}

/// it have, they goes, I is.
void find_after_pronoun(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool third = is_third_singular(sentence.text(i));
    const bool other = is_other_person(sentence.text(i));
    const FreeWord& subject = sentence[i];
    if (subject.hyphen_behind || (!third && !other) || sentence[i].before_stop ||
        (!sentence.clause_begins(i) && !resumes(sentence, i) &&
         // "The closer you is".
         !(other && sentence[i - 1].degree == Degree::comparative &&
           sentence.is(i - 2, {"the"})))) {
        return;
    }
    // "If it were", "suggest that it go", and "you and I".
    const bool wish = sentence.is(i - 1, {"if", "though"});
    const int at = verb_behind(sentence, i + 1);
    const FreeWord& verb = sentence[at];
    const std::string& pronoun = sentence.text(i);
    if (sentence.is(i, {"he", "she"}) && sentence.is(at, {"like"})) {
        proposals.replace(at, ErrorCode::agreement, "likes");
        return;
    }
    if (verb.text == "am") {
        if (pronoun != "i") {
            proposals.replace(at, ErrorCode::agreement, third ? "is" : "are");
        }
        return;
    }
    if (pronoun == "i" && sentence.is(at, {"is", "are", "was", "were"}) && !verb.possessive) {
        if (verb.text != "was" && !(wish && verb.text == "were")) {
            proposals.replace(at, ErrorCode::agreement, verb.text == "were" ? "was" : "am");
        }
        return;
    }
    if (verb.text == "were" && wish) {
        return;
    }
    const std::string right = agreeing(sentence, at, third ? Number::singular : Number::plural);
    const bool grammar_verb = verb.closed;
    const int weight = pronoun == "it" ? 1 : 4;
    const bool likely = grammar_verb || (verb.verb_count * weight >= verb.noun_count &&
                                         verb.verb_count >= verb.adjective_count);
    if (right.empty() || !likely || (wish && third && !grammar_verb)) {
        return;
    }
    proposals.replace(at, ErrorCode::agreement, right);
}

/// "bug" of "there are bug in": no verb can stand there.
bool is_bare_singular(const FreeWord& word) {
    return word.noun_count > 0 && word.adjective_count == 0 && word.can_be_singular &&
           word.singular.empty() && !is_mass_noun(word.text) && !is_collective(word.text) &&
           word.text != "plenty" && word.text != "dozen";
}

/// there is two moons, there are person, is there women.
void find_after_there(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!sentence.is(i, {"there"}) || sentence[i].before_stop) {
        return;
    }
    const bool turned = sentence.be_at(i - 1) && !sentence[i].behind_stop &&
                        (i == 1 || sentence.clause_begins(i - 1) || sentence[i - 2].closed) &&
                        !is_third_singular(sentence.text(i - 2)) &&
                        !is_other_person(sentence.text(i - 2)) &&
                        !sentence.is(i - 2, {"that", "this", "who", "which", "there"});
    const bool straight =
        sentence.be_at(i + 1) && !turned &&
        (i == 0 || sentence[i].behind_stop || (sentence[i - 1].closed && !sentence.be_at(i - 1)) ||
         is_telling_verb(sentence.text(i - 1)) ||
         (sentence[i - 1].mainly_noun() && sentence.is(0, {"in", "on", "at", "under", "near"})));
    if (!turned && !straight) {
        return;
    }
    const int be = turned ? i - 1 : i + 1;
    int first = (turned ? i : i + 1) + 1;
    if (sentence[first - 1].before_stop) {
        return;
    }
    while (sentence.is(
        first, {"not", "also", "always", "only", "still", "really", "any", "some", "now"})) {
        ++first;
    }
    const bool one = sentence.is(be, {"is", "was"});
    // "There is four", "there is two forces".
    const FreeWord& counted = sentence[first + 1];
    if (one && sentence[first].number && !sentence.is(first, {"one"}) &&
        (sentence.ends_at(first) ||
         (!counted.singular.empty() && counted.noun_count > 0 && sentence.is_head(first + 1)))) {
        proposals.replace(be, ErrorCode::agreement, sentence.text(be) == "is" ? "are" : "were");
        return;
    }
    const bool amount = sentence.is(first, {"many", "several", "few", "lots"}) ||
                        (sentence[first].number && !sentence[first].before_stop);
    const NounPhrase phrase = noun_phrase_at(sentence, first);
    if (phrase.first == phrase.last || !sentence.is_head(phrase.head)) {
        return;
    }
    const FreeWord& noun = sentence[phrase.head];
    const bool bare = phrase.head == first;
    const bool plural = noun.plural_noun() || (bare && !noun.singular.empty() &&
                                               !noun.can_be_singular && noun.singular != noun.text);
    const bool followed_by_and =
        sentence.is(phrase.last, {"and", "or"}) ||
        (sentence[phrase.head].before_stop && !sentence.ends_at(phrase.head));
    if (one && (plural || (amount && noun.noun_count > 0)) &&
        !sentence.is(first, {"a", "an", "the", "this", "that", "one", "each", "every", "no"})) {
        proposals.replace(be, ErrorCode::agreement, sentence.text(be) == "is" ? "are" : "were");
    } else if (!one && bare && is_material(noun.text) && !followed_by_and &&
               (sentence.ends_at(first) || sentence[first + 1].closed)) {
        proposals.replace(be, ErrorCode::agreement, sentence.text(be) == "are" ? "is" : "was");
    } else if (!one && sentence.is(first, {"no"}) &&
               (is_mass_noun(noun.text) || is_measured(noun.text) || noun.text == "difference")) {
        proposals.replace(be, ErrorCode::agreement, sentence.text(be) == "are" ? "is" : "was");
    } else if (!one && (noun.singular_noun() || (bare && is_bare_singular(noun))) && !amount &&
               !followed_by_and && !sentence.is(first, {"no", "the"}) &&
               plural_of(noun.text) != noun.text && sentence.is(be, {"are", "were"})) {
        const bool determined = phrase.determined;
        if (determined && sentence.is(first, {"a", "an", "one", "this", "that"})) {
            proposals.replace(be, ErrorCode::agreement, sentence.text(be) == "are" ? "is" : "was");
        } else if (!determined) {
            proposals.replace(phrase.head, ErrorCode::noun_number, plural_of(noun.text));
        }
    }
}

/// The same where it is certain to be named there, and no verb or adjective: a thing, a material or a planet.
int certain_name_end(const FreeSentence& sentence, int first) {
    const NounPhrase phrase = noun_phrase_at(sentence, first);
    const bool certain = phrase.determined || sentence[phrase.head].thing ||
                         is_material(sentence[phrase.head].text) || is_planet(sentence.text(first));
    return certain ? name_end(sentence, first) : first;
}

/// the apple and the egg is equal.
void find_after_two(const FreeSentence& sentence, Proposals& proposals) {
    const int begin = sentence.is(0, {"both"}) ? 1 : 0;
    const int first = certain_name_end(sentence, begin);
    const int second = sentence.is(first, {"and"}) ? certain_name_end(sentence, first + 1) : first;
    if (first == begin || second <= first + 1 || sentence[second - 1].before_stop ||
        sentence[first - 1].before_stop || sentence.asks() ||
        sentence.is(begin, {"each", "every", "no"}) || sentence[second].possessive) {
        return;
    }
    const std::string right = agreeing(sentence, second, Number::plural);
    if (!right.empty() && sentence[second].closed) {
        proposals.replace(second, ErrorCode::agreement, right);
    }
}

/// the planets goes, the moon are, Jupiter have; two subjects joined: the apple and the egg is.
void find_after_noun(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!sentence.clause_begins(i) || (i > 0 && sentence[i].behind_stop && !sentence[i].capital &&
                                       !is_determiner(sentence.text(i)))) {
        return;
    }
    NounPhrase phrase = noun_phrase_at(sentence, i);
    const bool planet = is_planet(sentence.text(i));
    if (planet) {
        phrase = {i, i + 1, i, true, true, Number::singular};
    }
    const FreeWord& noun = sentence[phrase.head];
    // "Avengers was …": hardly a plain word, so a name.
    const bool name =
        noun.capital && !phrase.determined &&
        (phrase.head > i || (phrase.number == Number::plural && noun.noun_count < kPlainWord));
    // "Three newtons is enough": an amount is one.
    const bool amount = sentence[phrase.first].number || noun.text.size() < 3;
    if (phrase.first == phrase.last || !phrase.sure || name || amount ||
        sentence[phrase.head].before_stop ||
        sentence.is(phrase.first, {"what", "which", "whose", "all", "no", "both", "any", "some"})) {
        return;
    }
    // "The force of the weight are": both are one.
    const NounPhrase hung = noun_phrase_at(sentence, phrase.last + 1);
    const bool of_one = phrase.determined && phrase.number == Number::singular &&
                        sentence.is(phrase.last, {"of", "from", "in"}) && hung.last > hung.first &&
                        hung.determined && hung.sure && hung.number == Number::singular &&
                        sentence.is(hung.last, {"are", "were"});
    const int at = of_one ? hung.last : verb_behind(sentence, phrase.last);
    const FreeWord& verb = sentence[at];
    const bool wish =
        sentence.is(i - 1, {"if", "though", "that"}) && sentence.is(at, {"were", "be"});
    const std::string right = agreeing(sentence, at, phrase.number);
    if (right.empty() || wish || sentence.asks()) {
        return;
    }
    const bool grammar_verb = verb.closed;
    const bool lexical =
        verb.mainly_verb() || (verb.verb_count > verb.noun_count && !sentence.ends_at(at) &&
                               sentence[at + 1].closed && phrase.determined);
    const bool bare_singular = !phrase.determined && phrase.number == Number::singular &&
                               !is_mass_noun(sentence[phrase.head].text) &&
                               !is_material(sentence[phrase.head].text) && !planet;
    if (grammar_verb && !bare_singular) {
        proposals.replace(at, ErrorCode::agreement, right);
    } else if (grammar_verb || (lexical && phrase.determined)) {
        proposals.replace(at, ErrorCode::agreement, right,
                          grammar_verb ? Certainty::sure : Certainty::asked);
    } else if (lexical && !sentence.ends_at(at)) {
        proposals.replace(at, ErrorCode::agreement, right, Certainty::asked);
    }
}

}  // namespace

void find_agreement_errors(const FreeSentence& sentence, Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_after_pronoun(sentence, i, proposals);
        find_after_there(sentence, i, proposals);
        find_after_noun(sentence, i, proposals);
    }
    find_after_two(sentence, proposals);
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
