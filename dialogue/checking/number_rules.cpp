// Errors of one and many in a free sentence.
#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/proposal.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/noun.h"
#include "dialogue/english/number.h"

#include <algorithm>

// Each rule is one chain of conditions, told in the order in which the grammar has them.
// NOLINTBEGIN(readability-function-cognitive-complexity,bugprone-branch-clone)
namespace fulcrum::dialogue {
namespace {

constexpr int kHardlyVerb = 10;          // "mans" could be what a crew does
constexpr std::size_t kYear_digits = 4;  // "2020 film" is of that year

/// The plural that the lexicon or the rules give.
std::string plural_in(const Lexicon& lexicon, const std::string& noun) {
    const std::string plural = plural_of(noun);
    const std::vector<std::string> irregular = lexicon.irregular_plurals(noun);
    const bool regular = irregular.empty() ||
                         std::find(irregular.begin(), irregular.end(), plural) != irregular.end();
    return regular ? plural : irregular.front();
}

/// The head of the words behind `first`: adjectives may stand between.
int head_behind(const FreeSentence& sentence, int first) {
    int head = first + 1;
    while (!sentence[head - 1].before_stop && sentence[head].mainly_adjective() &&
           head < first + 4) {
        ++head;
    }
    return head;
}

/// "many", "several", "two" and what else asks for a plural.
bool asks_for_plural(const FreeSentence& sentence, int i) {
    const FreeWord& word = sentence[i];
    if (word.before_stop) {
        return false;
    }
    if (sentence.is(i, {"many", "several", "both", "various"}) || sentence.is(i, {"few"})) {
        return !sentence.is(i - 1, {"as"}) || sentence.is(i, {"many"});
    }
    int first = i;  // of "twenty five"
    while (first > 0 && word.number && !sentence[first - 1].before_stop &&
           is_number_word(sentence.text(first - 1)) && !sentence.is(first - 1, {"one"})) {
        --first;
    }
    const FreeWord& before = sentence[first - 1];
    const bool in_name = before.mainly_noun() || (before.capital && first > 1) || before.number ||
                         sentence.is(first - 1, {"the", "a", "an", "in", "at", "on", "every", "per",
                                                 "by", "and", "point", "of"});
    return word.number && word.begin != sentence[i + 1].begin && (first == 0 || !in_name) &&
           !sentence.is(i, {"hundred", "thousand", "million"}) &&
           !(word.written.find_first_not_of("0123456789") == std::string::npos &&
             word.written.size() >= kYear_digits);
}

/// two moon, many kind of.
void find_after_number(const Lexicon& lexicon, const FreeSentence& sentence, int i,
                       Proposals& proposals) {
    if (!asks_for_plural(sentence, i)) {
        return;
    }
    const int head = head_behind(sentence, i);
    const FreeWord& noun = sentence[head];
    if (sentence.is(i, {"both"}) && sentence.is(head + 1, {"and"})) {
        return;  // "both the apple and the egg", without its articles
    }
    const bool kind = sentence.is(head, {"kind", "sort", "type"}) && sentence.is(head + 1, {"of"});
    if (is_strictly_mass(noun.text) && sentence.is(i, {"many", "few"}) && sentence.is_head(head)) {
        const std::string right = sentence.is(i, {"many"}) ? "much" : "little";
        proposals.replace(i, ErrorCode::wrong_determiner, right);
        return;
    }
    const bool unit = noun.text.size() < 3;  // "20 N"
    // "Ten moon turn round it".
    const FreeWord& next = sentence[head + 1];
    const bool acts = i == 0 && next.verb_plain && !next.verb_in_s && next.verb_count > 0 &&
                      !next.before_stop &&
                      (sentence[head + 2].closed || sentence.is(head + 2, {"round"}));
    const bool wrong =
        kind || (noun.singular_noun() && (sentence.is_head(head) || acts) && !noun.possessive &&
                 !is_strictly_mass(noun.text) && plural_of(noun.text) != noun.text &&
                 !sentence[head + 1].possessive && !sentence.is(head + 1, {"old", "one"}));
    const bool joined = head + 1 < sentence.size() && sentence[head + 1].begin == noun.end + 1 &&
                        noun.before_stop && !sentence[head + 1].closed &&
                        noun.end > 0;  // "two-door car", "five star-shaped"
    if (wrong && !joined && !unit && !(noun.capital && head > 0)) {
        proposals.replace(head, ErrorCode::noun_number, plural_in(lexicon, noun.text));
    }
}

/// one of the best movie.
void find_one_of(const Lexicon& lexicon, const FreeSentence& sentence, int i,
                 Proposals& proposals) {
    if (!sentence.is(i, {"one"}) || !sentence.is(i + 1, {"of"}) ||
        !(sentence.is(i + 2, {"the", "these", "those"}) || is_possessive(sentence.text(i + 2)))) {
        return;
    }
    int head = i + 3;
    const bool most = sentence.is(head, {"most"});
    head += most ? 1 : 0;
    while (sentence[head].adjective_count > sentence[head].noun_count &&
           !sentence[head].before_stop) {
        ++head;
    }
    const FreeWord& noun = sentence[head];
    if (noun.singular_noun() && sentence.is_head(head) && !noun.capital) {
        proposals.replace(head, ErrorCode::noun_number, plural_in(lexicon, noun.text));
    }
}

/// one moons, each planets, every days.
void find_after_one(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!sentence.is(i, {"one", "each", "every", "another"}) || sentence[i].before_stop ||
        sentence[i].number) {
        return;
    }
    const int head = head_behind(sentence, i);
    const FreeWord& noun = sentence[head];
    const bool verb = noun.verb_in_s && noun.verb_count * 8 > noun.noun_count;
    if (noun.plural_noun() && !verb && noun.text != "people" && sentence.is_head(head) &&
        !noun.capital && !is_plural_only(noun.text)) {
        proposals.replace(head, ErrorCode::noun_number, noun.singular);
    }
}

/// much moons.
void find_much(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!sentence.is(i, {"much"}) || sentence[i].before_stop) {
        return;
    }
    const FreeWord& noun = sentence[i + 1];
    if (noun.plural_noun() && !noun.verb_in_s && sentence.is_head(i + 1) && noun.text != "news") {
        proposals.replace(i, ErrorCode::wrong_determiner, "many");
    } else if (noun.plural_noun() && sentence.is(i - 1, {"how", "so", "too"}) &&
               noun.noun_count > noun.verb_count) {
        proposals.replace(i, ErrorCode::wrong_determiner, "many");
    }
}

/// moones, mans, mices, informations; "of metals".
void find_inflection(const Lexicon& lexicon, const FreeSentence& sentence, int i,
                     Proposals& proposals) {
    const FreeWord& word = sentence[i];
    if (lexicon.has(sentence.text(i - 1) + "_" + word.text, WordKind::noun)) {
        return;  // "los angeles"
    }
    if (word.closed || !word.text.ends_with('s') || (word.capital && i > 0) ||
        word.text.size() < 4) {
        return;
    }
    if (is_strictly_mass(word.singular) && word.singular != word.text) {
        proposals.replace(i, ErrorCode::noun_number, word.singular);
        return;
    }
    const std::string stem = word.text.substr(0, word.text.size() - 1);
    const bool made_of = is_material(stem) && sentence.is(i - 1, {"of"}) &&
                         sentence.is(i - 2, {"made"}) && sentence.ends_at(i) && stem != "brick" &&
                         stem != "stone" && stem != "rock";
    if (made_of) {
        proposals.replace(i, ErrorCode::noun_number, stem);
        return;
    }
    // "Hourss" is of an hour, though "hours" stand in the lexicon too.
    std::vector<std::string> nouns = lexicon.bases(stem, WordKind::noun);
    nouns.push_back(stem);
    if (stem.ends_with('e')) {
        nouns.push_back(stem.substr(0, stem.size() - 1));
    }
    const bool mistaken =
        !word.known || (word.noun_count <= 1 && word.verb.empty() && !word.can_be_singular);
    for (const std::string& noun : nouns) {
        if (!lexicon.has(noun, WordKind::noun) || lexicon.count(noun, WordKind::noun) == 0) {
            continue;
        }
        const std::vector<std::string> wrong = learner_plurals(noun);
        const std::string plural = noun == "people" ? noun : plural_in(lexicon, noun);
        const bool is_wrong =
            plural != word.text &&
            (std::find(wrong.begin(), wrong.end(), word.text) != wrong.end() || plural == stem);
        const bool irregular = !lexicon.irregular_plurals(noun).empty() && word.singular == noun &&
                               word.text == noun + "s" && plural_of(noun) != word.text &&
                               plural == plural_of(noun);
        if (is_wrong && (mistaken || irregular) &&
            (word.verb.empty() || word.noun_count > kHardlyVerb * word.verb_count)) {
            proposals.replace(i, ErrorCode::noun_inflection, plural);
            return;
        }
    }
}

}  // namespace

void find_number_errors(const Lexicon& lexicon, const FreeSentence& sentence,
                        Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_after_number(lexicon, sentence, i, proposals);
        find_one_of(lexicon, sentence, i, proposals);
        find_after_one(sentence, i, proposals);
        find_much(sentence, i, proposals);
        find_inflection(lexicon, sentence, i, proposals);
    }
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
