// Errors of a, an, the, this and these in a free sentence.
#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/checking/proposal.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/number.h"

#include <algorithm>

// Each rule is one chain of conditions, told in the order in which the grammar has them.
// NOLINTBEGIN(readability-function-cognitive-complexity,bugprone-branch-clone)
namespace fulcrum::dialogue {
namespace {

bool is_indefinite(const FreeSentence& sentence, int i) {
    // A letter A: "an A in music".
    return sentence.is(i, {"a", "an"}) && !(sentence[i].capital && i > 0);
}

/// One that the ear decides by its letters alone: no abbreviation, no name written Like-ThiS.
bool is_plain_word(const FreeWord& word) {
    const auto upper = [](char letter) { return letter >= 'A' && letter <= 'Z'; };
    const auto vowel = [](char letter) { return is_vowel_letter(letter) || letter == 'y'; };
    const bool odd = word.written.empty() ||
                     std::any_of(word.written.begin() + 1, word.written.end(), upper) ||
                     (upper(word.written[0]) && word.written.size() == 1) ||
                     std::none_of(word.text.begin(), word.text.end(), vowel);
    return !odd && (word.known || !(word.text.starts_with('u') || word.text.starts_with("eu")));
}

/// a apple, an banana.
void find_sound(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& next = sentence[i + 1];
    if (!is_indefinite(sentence, i) || sentence[i].before_stop || next.text.empty() ||
        !is_plain_word(next) || both_articles(next.text)) {
        return;
    }
    const std::string_view right = indefinite_article(next.written);
    if (right != sentence.text(i)) {
        proposals.replace(i, ErrorCode::wrong_determiner, right);
    }
}

/// a information, a moons, a hard; made of a metal.
void find_after_indefinite(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!is_indefinite(sentence, i) || sentence[i].before_stop) {
        return;
    }
    int head = i + 1;
    while (sentence[head].mainly_adjective() && !sentence[head].before_stop && head < i + 3) {
        ++head;
    }
    const FreeWord& noun = sentence[head];
    if (is_strictly_mass(noun.text) && sentence.is_head(head)) {
        proposals.replace(i, ErrorCode::extra_determiner, "");
    } else if (is_plural_only(noun.text) && sentence.is_head(head)) {
        proposals.replace(i, ErrorCode::extra_determiner, "");
    } else if (noun.plural_noun() && !noun.capital && sentence.is_head(head) &&
               noun.text != "people" &&
               !sentence.is(head, {"means", "lots", "times", "hundreds"}) && head == i + 1) {
        proposals.replace(head, ErrorCode::noun_number, noun.singular);
    }
    const bool material = is_material(noun.text) && head == i + 1 && sentence.ends_at(head) &&
                          sentence.is(i - 1, {"of"}) &&
                          sentence.is(i - 2, {"made", "make", "makes"});
    if (material) {
        proposals.replace(i, ErrorCode::extra_determiner, "");
    }
    const FreeWord& last = sentence[i + 1];
    const bool alone = sentence.ends_at(i + 1) || sentence.is(i + 2, {"and", "but"});
    const bool be = sentence.be_at(i - 1) || is_linking_verb(sentence[i - 1].verb);
    if (be && is_physical(last.text) && last.mainly_adjective() && alone) {
        proposals.replace(i, ErrorCode::extra_determiner, "");
    }
}

/// need, wants: what somebody hasn't got yet comes behind them.
bool is_wanting(const FreeSentence& sentence, int i) {
    return sentence.is(i, {"need", "needs", "needed", "want", "wants", "wanted"});
}

/// the a, my the, the some; the Jupiter.
void find_doubled_determiner(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!is_central_determiner(sentence.text(i)) || sentence[i].before_stop ||
        (sentence[i].capital && i > 0)) {
        return;
    }
    const bool doubled = sentence.is(i + 1, {"a", "an", "the", "my", "your", "our", "their"}) &&
                         !sentence[i + 1].capital && !sentence[i + 1].before_stop &&
                         !sentence.is(i, {"her", "his", "its"});
    const bool some = sentence.is(i, {"the"}) && sentence.is(i + 1, {"some"});
    if ((doubled && sentence.text(i) != sentence.text(i + 1)) || some) {
        // "It wants the a tail": none that is there already.
        const bool wanted = is_wanting(sentence, i - 1) && is_indefinite(sentence, i + 1);
        const int wrong = some || wanted || is_possessive(sentence.text(i + 1)) ? i : i + 1;
        proposals.replace(wrong, ErrorCode::extra_determiner, "");
    }
    // "There is no the wind".
    if (sentence.is(i, {"a", "an", "the"}) && i > 0 && !sentence[i].behind_stop &&
        sentence.is(i - 1, {"no", "any"}) && sentence[i + 1].noun_count > 0 &&
        !(sentence.is(i - 1, {"no"}) && i == 1)) {
        proposals.replace(i, ErrorCode::extra_determiner, "");
        return;
    }
    const bool planet = is_planet(sentence.text(i + 1)) && sentence[i + 1].capital &&
                        !sentence[i + 2].mainly_noun() && !sentence[i + 2].possessive;
    if (sentence.is(i, {"the"}) && planet) {
        proposals.replace(i, ErrorCode::extra_determiner, "");
    }
}

/// these rock, this moons, this two moons.
void find_pointing(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool one = sentence.is(i, {"this", "that"});
    const bool more = sentence.is(i, {"these", "those"});
    if ((!one && !more) || sentence[i].before_stop) {
        return;
    }
    const bool near = sentence.is(i, {"this", "these"});
    int head = i + 1;
    while (sentence[head].mainly_adjective() && !sentence[head].before_stop && head < i + 3) {
        ++head;
    }
    const FreeWord& noun = sentence[head];
    if (one && sentence[i + 1].number && sentence[i + 2].plural_noun() &&
        sentence.text(i) == "this") {
        proposals.replace(i, ErrorCode::wrong_determiner, "these");
    } else if (one && noun.plural_noun() && sentence.is_head(head) && !noun.verb_in_s &&
               sentence.text(i) == "this") {
        proposals.replace(i, ErrorCode::wrong_determiner, near ? "these" : "those");
    } else if (more && noun.noun_count > 0 && noun.can_be_singular && noun.singular.empty() &&
               !noun.closed && !is_collective(noun.text) && plural_of(noun.text) != noun.text) {
        const FreeWord& next = sentence[head + 1];
        const bool verb_is_one = sentence.is(head + 1, {"is", "was", "has", "does"}) ||
                                 (next.verb_in_s && next.mainly_verb());
        const bool place = sentence.is(i - 1, {"near", "under", "behind", "with", "without", "of",
                                               "in", "on", "like", "at", "is", "has", "have"});
        const bool certain =
            (noun.singular_noun() && (noun.verb.empty() || place)) || (place && noun.mainly_noun());
        if (!verb_is_one &&
            (!certain || !sentence.is_head(head) || sentence.is(head + 1, {"and", "or"}))) {
            return;
        }
        if (verb_is_one) {
            proposals.replace(i, ErrorCode::wrong_determiner, near ? "this" : "that");
        } else {
            proposals.replace(head, ErrorCode::noun_number, plural_of(noun.text));
        }
    }
}

/// A subject that is certain: its verb follows.
bool begins_clause(const FreeSentence& sentence, int first, int noun) {
    const FreeWord& next = sentence[noun + 1];
    const bool physical =
        first == noun || is_physical(sentence.text(first)) || is_material(sentence.text(first));
    return physical && (sentence.be_at(noun + 1) || is_modal(next.text) ||
                        sentence.is(noun + 1, {"has", "have", "does", "do", "had"}) ||
                        (next.verb_in_s && next.mainly_verb()));
}

/// a heaviest thing, an Earth, the far from, a five moons.
void find_around_article(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (sentence[i].before_stop) {
        return;
    }
    const FreeWord& next = sentence[i + 1];
    const bool superlative =
        next.degree == Degree::superlative && next.adjective_count > next.noun_count &&
        !sentence.is(i + 1, {"best", "worst", "latest", "most", "least", "last", "first"}) &&
        !next.closed;
    const bool earth = next.written == "Earth" && sentence.is_head(i + 1);
    if (is_indefinite(sentence, i) && (superlative || earth)) {
        proposals.replace(i, ErrorCode::wrong_determiner, "the");
    } else if (sentence.is(i, {"the", "a"}) && sentence.is(i + 1, {"far"}) &&
               sentence.is(i + 2, {"from"})) {
        proposals.replace(i, ErrorCode::extra_determiner, "");
    } else if (is_indefinite(sentence, i) && next.number &&
               (sentence[i + 2].plural_noun() ||
                (sentence[i + 2].singular_noun() && is_number_word(next.text))) &&
               sentence.is_head(i + 2) && !next.hyphen_behind &&
               !sentence.is(i + 1, {"hundred", "thousand", "million", "dozen"})) {
        proposals.replace(i, ErrorCode::extra_determiner, "");
    } else if (sentence.is(i - 1, {"how"}) && sentence.is(i, {"a", "an", "the"}) &&
               is_physical(next.text)) {
        proposals.replace(i, ErrorCode::extra_determiner, "");
    }
    const bool first = i == 0 && sentence[0].degree == Degree::superlative &&
                       is_physical(sentence[0].adjective) && !sentence.is(0, {"best", "worst"}) &&
                       !sentence.asks() &&
                       (sentence.be_at(1) || (sentence[1].noun_count > 0 && sentence.be_at(2)) ||
                        sentence.is(1, {"one"}));
    if (first) {
        proposals.insert(0, ErrorCode::missing_determiner, "the");
    }
}

/// Egg is heavier; it is under blue block: of a thing that stands there, so that nobody has to be asked.
void find_bare_thing(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& noun = sentence[i];
    const FreeWord& next = sentence[i + 1];
    // Alone it is an answer; "egg yolk", "egg-like", "egg's", "apple and egg" and a name are other things.
    // "Apple and a watermelon": one with an article, one without.
    const bool other_has_one =
        i == 0 && sentence.is(1, {"and"}) && noun_phrase_at(sentence, 2).determined;
    const bool both =
        other_has_one || (sentence.is(i - 1, {"both"}) && sentence.is(i + 1, {"and"}));
    if (!noun.thing || sentence.size() == 1 || noun.possessive || noun.hyphen_behind ||
        (noun.capital && i > 0) || (!sentence.is_head(i) && next.degree != Degree::comparative) ||
        (!both && sentence.is(i + 1, {"and", "or"})) ||
        (next.noun_count > 0 && next.mainly_noun() && !noun.before_stop)) {
        return;
    }
    int first = i;
    while (first > 0 && !sentence[first].behind_stop && !sentence[first - 1].closed &&
           !sentence.is(first - 1, {"nearer", "closer"}) &&
           (sentence[first - 1].mainly_adjective() || is_material(sentence.text(first - 1)))) {
        --first;
    }
    const bool starts =
        first == 0 || sentence[first].behind_stop ||
        sentence.is(first - 1, {"yes", "no", "because", "but", "if", "when", "that"});
    const bool subject = starts && (sentence.be_at(i + 1) || is_modal(next.text) ||
                                    sentence.is(i + 1, {"has", "does", "did", "had"}) ||
                                    (next.verb_in_s && next.verb_count > 0 && !next.closed));
    const bool on_top = sentence.is(i, {"top"}) && sentence.is(first - 1, {"on", "at"});
    // "We make it from cloth".
    const bool made = sentence.has_before(first, "make");
    const bool place =
        !(made && sentence.is(first - 1, {"from"})) &&
        (sentence.is(first - 1,
                     {"than", "near", "nearer", "under", "behind", "on", "to", "towards", "at",
                      "below", "above", "beside", "in", "from", "without", "into"}) ||
         (sentence.is(first - 1, {"as"}) && sentence.is(first - 3, {"as", "so"})) ||
         (sentence.is(first - 1, {"of"}) &&
          sentence.is(first - 2, {"top", "tension", "weight", "pull", "end", "side", "middle",
                                  "drag", "lift", "force", "pole", "axis"})));
    const FreeWord& before = sentence[first - 1];
    const bool wanted = is_wanting(sentence, first - 1);
    // "We would change line", "make tail longer".
    const bool can_act =
        before.mainly_verb() ||
        (first == 1 && before.verb_plain && before.verb_count > before.noun_count) ||
        (before.verb_count > 0 &&
         (is_modal(sentence.text(first - 2)) || sentence.is(first - 2, {"to", "me", "us"})));
    const bool acts =
        wanted ||
        (can_act && !before.closed &&
         (before.verb_in_s || (before.verb_plain && (sentence.ends_at(i) || next.closed ||
                                                     next.degree == Degree::comparative))));
    const bool given = sentence.is(first - 2, {"give", "gives"}) && sentence.ends_at(i) &&
                       sentence.is(first - 1, {"it", "them"});
    const bool object = !on_top && (both || place || sentence.be_at(first - 1) || acts || given);
    // "Give it longer tail": it isn't there yet.
    const bool other = first < i && !subject && sentence[first].degree == Degree::comparative;
    if (subject || other_has_one || (object && !sentence[first].behind_stop)) {
        proposals.insert(first, ErrorCode::missing_determiner,
                         wanted || other ? indefinite_article(sentence.text(first)) : "the");
    }
}

/// Heavier one; is heaviest thing: what is compared is a certain one.
void find_bare_one(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& word = sentence[i];
    const bool compared = word.degree == Degree::comparative && is_physical(word.adjective) &&
                          sentence.is(i + 1, {"one"}) && !word.before_stop;
    const bool open = i == 0 || word.behind_stop || (sentence.be_at(i - 1) && !sentence.asks());
    const FreeWord& next = sentence[i + 2];  // "it is heavier one day"
    if (compared && open && (sentence.ends_at(i + 1) || next.closed || next.noun_count == 0)) {
        proposals.insert(i, ErrorCode::missing_determiner, "the");
    }
}

/// It has only moon: a judge has to say so too.
void find_only(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& noun = sentence[i];
    if (sentence.is(i - 1, {"only"}) && sentence.is(i - 2, {"has", "have", "is"}) &&
        !noun.possessive && (noun.thing || noun.singular_noun()) && sentence.is_head(i)) {
        proposals.insert(i, ErrorCode::missing_determiner, "one", Certainty::asked);
    }
}

/// I have apple; apple is heavy: a judge has to say so too.
void find_missing(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& noun = sentence[i];
    const bool capital_inside = noun.capital && (i > 0 || noun.noun_count < kPlainWord);
    if (noun.thing || !noun.singular_noun() || capital_inside || noun.possessive ||
        !sentence.is_head(i) || is_planet(noun.text) || noun.written == "Earth" ||
        is_month_or_day(noun.text) || is_time_or_amount(noun.text)) {
        return;
    }
    int first = i;
    while (
        first > 0 && !sentence[first].behind_stop && sentence[first - 1].mainly_adjective() &&
        (sentence[first - 1].degree == Degree::positive ||
         (sentence[first - 1].degree == Degree::comparative && is_wanting(sentence, first - 2)))) {
        --first;
    }
    const FreeWord& before = sentence[first - 1];
    const bool open = first == 0 || sentence[first].behind_stop ||
                      sentence.is(first - 1, {"is", "was"}) ||
                      sentence.is(first - 1, {"than", "like", "has", "have", "near", "under",
                                              "behind", "around", "towards"}) ||
                      is_wanting(sentence, first - 1) || (before.mainly_verb() && !before.closed);
    const bool starts = first == 0 || sentence[first].behind_stop;
    if (!open || before.number || (starts && !begins_clause(sentence, first, i))) {
        return;
    }
    const std::string_view article = indefinite_article(sentence.text(first));
    proposals.insert(first, ErrorCode::missing_determiner, article, Certainty::asked);
}

}  // namespace

void find_article_errors(const FreeSentence& sentence, Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_sound(sentence, i, proposals);
        find_after_indefinite(sentence, i, proposals);
        find_doubled_determiner(sentence, i, proposals);
        find_pointing(sentence, i, proposals);
        find_around_article(sentence, i, proposals);
        find_bare_thing(sentence, i, proposals);
        find_bare_one(sentence, i, proposals);
        find_only(sentence, i, proposals);
        find_missing(sentence, i, proposals);
    }
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
