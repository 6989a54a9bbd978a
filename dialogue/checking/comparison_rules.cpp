// Errors of comparison in a free sentence.
#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/checking/proposal.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/word_table.h"

#include <algorithm>
#include <array>

// Each rule is one chain of conditions, told in the order in which the grammar has them.
// NOLINTBEGIN(readability-function-cognitive-complexity,bugprone-branch-clone)
namespace fulcrum::dialogue {
namespace {

/// Compared by an ending, but "more true" is heard as well.
constexpr auto kAlsoWithMore = std::to_array<std::string_view>(
    {"true", "clear", "proud", "fair", "fit",  "fond", "apt",   "keen", "sure",   "dead", "ill",
     "free", "whole", "such",  "open", "safe", "sad",  "human", "good", "little", "own",  "sick"});

/// Not compared by "than" here: "other than", "rather than".
constexpr auto kBeforeThan =
    std::to_array<std::string_view>({"other", "rather", "different", "sooner", "less", "fewer",
                                     "more", "else", "otherwise", "further", "farther"});

/// What a thing does well or better.
constexpr auto kMoving = std::to_array<std::string_view>(
    {"turn", "go", "move", "work", "fly", "roll", "slide", "spin", "swing"});

std::string first_form(std::string_view adjective, Degree degree) {
    return degree_forms(adjective, degree).front();
}

bool takes_ending(std::string_view adjective) {
    const Comparison how = comparison_of(adjective);
    return how == Comparison::ending || how == Comparison::irregular;
}

/// A comparative or superlative, and not rather a noun or verb of its own: "number", "paper", "water".
bool is_compared(const FreeWord& word) {
    return !word.closed && word.degree != Degree::positive &&
           word.adjective_count > word.noun_count && word.adjective_count > word.verb_count;
}

/// What stands before a predicate: is, feels, gets, and small adverbs between.
bool behind_be(const FreeSentence& sentence, int i) {
    int at = i - 1;
    if (sentence.is(at, {"and", "or"}) && is_physical(sentence.text(at - 1))) {
        at -= 2;
    }
    while (at > 0 &&
           (is_light_adverb(sentence.text(at)) || sentence.is(at, {"far", "all", "way"}))) {
        --at;
    }
    const bool turned =
        sentence.asks() && sentence.be_at(0) && sentence[at].closed;  // "is it more big?"
    return turned || sentence.be_at(at) || is_linking_verb(sentence[at].verb) ||
           sentence.is(at, {"be", "get", "gets", "got", "been"});
}

/// "the " where a superlative put in place of word `i` stands `alone` behind "is": what it needs there (find_bare_superlative).
std::string with_the(const FreeSentence& sentence, int i, Degree degree, bool alone) {
    const bool bare = degree == Degree::superlative && alone && sentence.be_at(i - 1);
    return bare && !sentence.is(i + 2, {"to", "from", "when", "where", "at", "in"}) ? "the " : "";
}

/// turns more fast, goes more good at the side, is more near to: never said so, wherever it stands.
bool is_moved(const FreeSentence& sentence, int i, Degree degree) {
    const FreeWord& before = sentence[i - 1];
    const bool alone = sentence.ends_at(i + 1) || sentence[i + 2].closed;
    const bool moves = contains(kMoving, before.verb);
    const bool good = sentence.is(i + 1, {"good"}) && moves && !sentence.is(i + 2, {"than"});
    // "It turns more near the pole": that is more, and near it.
    const bool near = sentence.is(i + 1, {"near"}) &&
                      (degree == Degree::superlative || sentence.is(i + 2, {"to"}) ||
                       (behind_be(sentence, i) && before.verb != "turn"));
    // An adverb as it stands: "flies more high", "pulls more hard". "It turns more low" may be any.
    const bool how = before.mainly_verb() && !before.closed &&
                     sentence.is(i + 1, {"high", "hard"}) && !sentence[i + 3].mainly_adjective();
    const bool fast = sentence.is(i + 1, {"fast"});
    return alone && (good || near || ((how || fast) && degree == Degree::comparative));
}

/// more heavier, most heaviest; more heavy, most heavy.
void find_doubled(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!sentence.is(i, {"more", "most"}) || sentence[i].before_stop) {
        return;
    }
    const FreeWord& word = sentence[i + 1];
    const Degree degree = sentence.text(i) == "more" ? Degree::comparative : Degree::superlative;
    if (is_compared(word)) {
        const bool alone = sentence.ends_at(i + 1) || sentence[i + 2].closed;
        const std::string right =
            with_the(sentence, i, degree, alone) + first_form(word.adjective, degree);
        proposals.replace(i, i + 2, ErrorCode::adjective_form, right);
        return;
    }
    if (sentence.is(i + 1, {"farther", "nearer", "faster", "closer"}) &&
        degree == Degree::comparative) {
        proposals.replace(i, i + 2, ErrorCode::adjective_form, word.text);
        return;
    }
    const bool adjective = word.mainly_adjective() ||
                           (is_physical(word.text) && word.adjective_count > 0 &&
                            (sentence.is(i - 1, {"the", "a", "an"}) || behind_be(sentence, i)));
    if (is_moved(sentence, i, degree)) {
        proposals.replace(i, i + 2, ErrorCode::adjective_form, first_form(word.text, degree));
        return;
    }
    const bool plain = adjective && word.degree == Degree::positive &&
                       word.text == word.adjective && takes_ending(word.text) &&
                       !contains(kAlsoWithMore, word.text);
    if (!plain) {
        return;
    }
    const bool before_noun = sentence.is(i - 1, {"a", "an"}) && is_physical(word.text) &&
                             sentence[i + 2].noun_count > 0 && sentence.is_head(i + 2);
    const bool named = sentence.is(i - 1, {"the"}) && is_physical(word.text) &&
                       (sentence.is(i + 2, {"one", "ones"}) ||
                        (sentence[i + 2].noun_count > 0 && sentence.is_head(i + 2) &&
                         (sentence.be_at(i + 3) || sentence.ends_at(i + 2))));
    // "Make the tail more long": made so.
    const bool made = sentence.ends_at(i + 1) && sentence.has_before(i - 1, "make") &&
                      sentence[i - 1].mainly_noun() && is_physical(word.text);
    const bool than = sentence.is(i + 2, {"than"}) && !sentence[i + 1].before_stop &&
                      !sentence[i + 3].mainly_adjective();
    // "More high than low places": more of them.
    const bool counts = sentence.is(i + 2, {"than"}) && sentence[i + 3].mainly_adjective();
    const bool alone = !counts && (sentence.ends_at(i + 1) || sentence[i + 2].closed ||
                                   sentence.is(i + 2, {"far", "near", "here"}));
    const bool superlative = degree == Degree::superlative;
    const bool fits =
        superlative ? sentence.is(i - 1, {"the"}) || (alone && behind_be(sentence, i))
                    : than || before_noun || named || made || (alone && behind_be(sentence, i));
    if (fits) {
        proposals.replace(i, i + 2, ErrorCode::adjective_form,
                          with_the(sentence, i, degree, alone) + first_form(word.text, degree));
    }
}

/// The adjectives that `word` could be a wrongly formed degree of: heavyer, biger, gooder, beautifuler.
std::vector<std::string> stems_of(std::string_view word, std::string_view ending) {
    std::string stem(word.substr(0, word.size() - ending.size()));
    std::vector<std::string> stems{stem, stem + "e"};
    if (stem.size() > 2 && stem.back() == stem[stem.size() - 2]) {
        stems.push_back(stem.substr(0, stem.size() - 1));
    }
    if (stem.ends_with("yi")) {
        stems.push_back(stem.substr(0, stem.size() - 1));
    } else if (stem.ends_with("i")) {
        stems.push_back(stem.substr(0, stem.size() - 1) + "y");
    } else {
        stems.push_back(stem + "y");
    }
    return stems;
}

void find_malformed(const Lexicon& lexicon, const FreeSentence& sentence, int i,
                    Proposals& proposals) {
    const FreeWord& word = sentence[i];
    if (word.closed || word.number || (word.known && word.degree != Degree::positive) ||
        (word.capital && i > 0)) {
        return;
    }
    for (const auto& [ending, degree] :
         {std::pair<std::string_view, Degree>{"er", Degree::comparative},
          {"est", Degree::superlative}}) {
        if (!word.text.ends_with(ending) || word.text.size() < ending.size() + 2) {
            continue;
        }
        for (const std::string& stem : stems_of(word.text, ending)) {
            const bool irregular = comparison_of(stem) == Comparison::irregular;
            if (!lexicon.has(stem, WordKind::adjective) || (word.known && !irregular) ||
                lexicon.count(stem, WordKind::adjective) == 0) {
                continue;
            }
            for (const LearnerForm& form : learner_forms(stem, degree)) {
                if (form.text == word.text && form.slip < 3) {
                    const bool doubled =
                        sentence.is(i - 1, {"more", "most"}) && !sentence[i].behind_stop;
                    proposals.replace(doubled ? i - 1 : i, i + 1,
                                      doubled ? ErrorCode::adjective_form : form.code,
                                      first_form(stem, degree));
                    return;
                }
            }
        }
    }
}

/// heavy than, worst than, heavier then.
void find_than(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& word = sentence[i];
    if (word.before_stop || word.closed || contains(kBeforeThan, word.text)) {
        return;
    }
    const bool more_before = sentence.is(i - 1, {"more", "less", "most", "least"}) ||
                             sentence.is(i - 2, {"more", "less"}) ||
                             sentence.is(i - 3, {"more", "less"});
    if (sentence.is(i + 1, {"than"})) {
        const bool plain = word.degree == Degree::positive && word.adjective == word.text &&
                           (word.adjective_count > word.noun_count || is_physical(word.text)) &&
                           behind_be(sentence, i);
        const bool superlative = is_compared(word) && word.degree == Degree::superlative;
        if (superlative) {
            const int first = sentence.is(i - 1, {"the"}) ? i - 1 : i;
            proposals.replace(first, i + 1, ErrorCode::adjective_form,
                              first_form(word.adjective, Degree::comparative));
        } else if (plain && !more_before) {
            proposals.replace(i, ErrorCode::adjective_form,
                              first_form(word.text, Degree::comparative));
        }
        return;
    }
    const bool comparative =
        (is_compared(word) && word.degree == Degree::comparative) || sentence.is(i - 1, {"more"});
    if (sentence.is(i + 1, {"then"}) && comparative &&
        (behind_be(sentence, sentence.is(i - 1, {"more"}) ? i - 1 : i) ||
         is_physical(word.adjective) || sentence.is(i, {"faster"})) &&
        !sentence[i + 1].before_stop) {
        const int rest = noun_phrase_at(sentence, i + 2).last;
        const bool goes_on = sentence.is(rest, {"when", "if", "as", "and", "because", "so"});
        const FreeWord& named = sentence[i + 2];
        const int place =
            sentence.is(i + 2, {"in", "without"}) ? noun_phrase_at(sentence, i + 3).last : i + 2;
        const bool names_thing =
            (rest > i + 2 &&
             (rest >= sentence.size() || sentence[rest - 1].before_stop || goes_on)) ||
            (is_planet(sentence.text(i + 2)) && sentence.ends_at(i + 2)) ||
            (sentence.is(i + 2, {"that", "this"}) && sentence.ends_at(i + 2)) ||
            (is_measured(named.text) && (sentence.ends_at(i + 2) || goes_on ||
                                         sentence.is(i + 3, {"now", "then", "there"}))) ||
            (!named.closed && named.noun_count > 0 && !named.verb_in_s && !named.mainly_verb() &&
             named.adverb_count == 0 && sentence.ends_at(i + 2)) ||
            (place > i + 3 &&
             (place >= sentence.size() || sentence.is(place, {"when", "if", "as"}))) ||
            (sentence.is(i + 2, {"before"}) &&
             (sentence.ends_at(i + 2) || sentence.is(i + 3, {"when", "if", "as"}))) ||
            (sentence.is(i + 2, {"the"}) && sentence.is(i + 3, {"other", "others"}) &&
             !sentence.be_at(i + 4)) ||
            (sentence.is(i + 2, {"all", "any"}) &&
             sentence.is(i + 3, {"the", "other", "others"})) ||
            (sentence.is(i + 2, {"everything", "anything"}) && sentence.is(i + 3, {"else"}));
        if (names_thing) {
            proposals.replace(i + 1, ErrorCode::wrong_preposition, "than");
        }
    }
}

/// heavier as the egg, stronger as before; not "heavier as a whole", "heavier as the day goes on".
void find_as(const FreeSentence& sentence, int i, Proposals& proposals) {
    const int named = name_end(sentence, i + 2);
    const bool thing =
        named > i + 2 && named >= sentence.size() &&
        (is_planet(sentence.text(i + 2)) ||
         (is_central_determiner(sentence.text(i + 2)) && !sentence.is(i + 2, {"a", "an"}) &&
          !is_time_or_amount(sentence[named - 1].text)));
    const bool before = sentence.is(i + 2, {"before"}) && sentence.ends_at(i + 2);
    if (sentence.is(i + 1, {"as"}) && !sentence[i].before_stop && !sentence[i + 1].before_stop &&
        !sentence.is(i - 1, {"as"}) && (thing || before) && behind_be(sentence, i)) {
        proposals.replace(i + 1, ErrorCode::wrong_preposition, "than");
    }
}

/// pulls more hardly, flies more fastly: adjectives that are adverbs as they stand.
void find_double_adverb(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (sentence.is(i, {"more"}) && !sentence[i].before_stop &&
        sentence.is(i + 1, {"hardly", "fastly"}) &&
        (sentence.ends_at(i + 1) || sentence.is(i + 2, {"than"}))) {
        proposals.replace(i, i + 2, ErrorCode::morphology,
                          sentence.is(i + 1, {"hardly"}) ? "harder" : "faster");
    }
}

/// is too much heavy.
void find_too_much(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& word = sentence[i + 2];
    if (sentence.is(i, {"too", "so", "very"}) && sentence.is(i + 1, {"much"}) &&
        sentence.be_at(i - 1) && is_physical(word.text) && word.mainly_adjective() &&
        word.degree == Degree::positive && !sentence[i + 1].before_stop &&
        (sentence.ends_at(i + 2) || sentence.is(i + 3, {"to", "and", "because"}))) {
        proposals.replace(i + 1, ErrorCode::wrong_adverb, "");
    }
}

/// heavier that the egg, heavier that before.
void find_that(const FreeSentence& sentence, int i, Proposals& proposals) {
    const int rest = noun_phrase_at(sentence, i + 2).last;
    const bool thing =
        rest > i + 2 && rest >= sentence.size() && is_central_determiner(sentence.text(i + 2));
    const bool before = sentence.is(i + 2, {"before"}) && sentence.ends_at(i + 2);
    if (sentence.is(i + 1, {"that"}) && !sentence[i].before_stop && (thing || before) &&
        behind_be(sentence, i)) {
        proposals.replace(i + 1, ErrorCode::wrong_preposition, "than");
    }
}

/// very more beautiful, feels much hard.
void find_very(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& next = sentence[i + 1];
    if (sentence.is(i, {"very"}) && sentence.is(i + 1, {"more"}) &&
        sentence[i + 2].adjective_count > 0) {
        proposals.replace(i, ErrorCode::wrong_adverb, "much");
    }
    const bool much = sentence.is(i, {"much"}) && is_physical(next.text) &&
                      next.mainly_adjective() && next.degree == Degree::positive &&
                      (sentence.ends_at(i + 1) || sentence.is(i + 2, {"and", "but"})) &&
                      (sentence.be_at(i - 1) || is_linking_verb(sentence[i - 1].verb));
    if (much) {
        proposals.replace(i, ErrorCode::wrong_adverb, "very");
    }
}

/// very heavier, as heavier as, the heavier than, is heaviest.
void find_around(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& word = sentence[i];
    if (!is_compared(word) || word.behind_stop) {
        return;
    }
    if (word.degree == Degree::comparative) {
        find_that(sentence, i, proposals);
        find_as(sentence, i, proposals);
        if (sentence.is(i - 1, {"very"}) && !sentence.is(i - 2, {"the"})) {
            proposals.replace(i - 1, ErrorCode::wrong_adverb, "much");
        }
        if (sentence.is(i - 1, {"as"}) && sentence.is(i + 1, {"as"})) {
            proposals.replace(i, ErrorCode::adjective_form, word.adjective);
        }
        if (sentence.is(i - 1, {"the"}) && sentence.is(i + 1, {"than"}) && !word.before_stop) {
            proposals.replace(i - 1, ErrorCode::extra_determiner, "");
        }
    }
}

/// "is heaviest", "is most beautiful": at the end of its clause, where nothing was asked with "which".
void find_bare_superlative(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool with_most = sentence.is(i, {"most"}) && !sentence[i].before_stop &&
                           sentence[i + 1].mainly_adjective() &&
                           sentence[i + 1].degree == Degree::positive;
    const bool inflected = is_compared(sentence[i]) && sentence[i].degree == Degree::superlative &&
                           !sentence.is(i, {"best", "worst", "latest", "closest", "nearest"});
    const int last = with_most ? i + 1 : i;
    const bool alone = sentence.ends_at(last) || sentence.is(last + 1, {"one", "of", "in"}) ||
                       (inflected && sentence[last + 1].singular_noun());
    const bool by_far = sentence.is(i - 1, {"far"}) && sentence.is(i - 2, {"by"});
    const int be = by_far ? i - 3 : (sentence.is(i - 1, {"not", "still"}) ? i - 2 : i - 1);
    if ((with_most || inflected) && sentence.be_at(be) && alone &&
        !is_question_word(sentence.text(0)) && !sentence.asks()) {
        proposals.insert(i, ErrorCode::missing_determiner, "the");
    }
}

}  // namespace

void find_comparison_errors(const Lexicon& lexicon, const FreeSentence& sentence,
                            Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_doubled(sentence, i, proposals);
        find_malformed(lexicon, sentence, i, proposals);
        find_than(sentence, i, proposals);
        find_around(sentence, i, proposals);
        find_very(sentence, i, proposals);
        find_too_much(sentence, i, proposals);
        find_double_adverb(sentence, i, proposals);
        find_bare_superlative(sentence, i, proposals);
    }
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
