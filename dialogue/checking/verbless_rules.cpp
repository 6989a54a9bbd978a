// Clauses without their verb that do not begin with their subject, or whose subject is more than a name.
#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/checking/proposal.h"

// Each rule is one chain of conditions, told in the order in which the grammar has them.
// NOLINTBEGIN(readability-function-cognitive-complexity,bugprone-branch-clone)
namespace fulcrum::dialogue {
namespace {

/// The apple and the egg the same; metal and wood alike; none heavier.
void find_missing_between(const FreeSentence& sentence, Proposals& proposals) {
    const bool none_compared =
        sentence.is(0, {"none"}) &&
        ((sentence[1].degree == Degree::comparative && sentence.ends_at(1)) ||
         (sentence.is(1, {"the"}) && sentence[2].degree == Degree::superlative &&
          sentence.ends_at(2)));
    if (none_compared && !sentence.asks()) {
        proposals.insert(1, ErrorCode::missing_verb, "is");
        return;
    }
    const int first = name_end(sentence, 0);
    const int second = name_end(sentence, first + 1);
    const bool alike =
        (sentence.is(second, {"the"}) && sentence.is(second + 1, {"same"})) ||
        (sentence.is(second, {"alike", "identical", "equal"}) && sentence.ends_at(second));
    if (first > 0 && sentence.is(first, {"and"}) && second > first + 1 && alike &&
        !sentence[second - 1].before_stop && !sentence.has_verb_from(0) && !sentence.asks()) {
        proposals.insert(second, ErrorCode::missing_verb, "are");
    }
}

/// "When we press far from it it easier", "near the pole it harder": the clause before it has no comma.
void find_missing_behind(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& word = sentence[i + 1];
    if (i > 1 && sentence.is(i, {"it"}) && !sentence[i].before_stop && !sentence.asks() &&
        word.degree == Degree::comparative && is_physical(word.adjective) &&
        (sentence.ends_at(i + 1) || sentence.is(i + 2, {"to", "than"})) &&
        sentence.is(0, {"when", "if", "near", "at", "on", "as", "far", "close"}) &&
        (!sentence[i - 1].mainly_verb() || is_determiner(sentence.text(i - 2))) &&
        !sentence.is(i - 1, {"make", "makes", "made", "is", "get"})) {
        proposals.insert(i + 1, ErrorCode::missing_verb, "is");
    }
}

/// "Pressing far from the support easier", "turning the Earth harder than turning Jupiter": what one does has a verb of its own too.
void find_missing_behind_doing(const FreeSentence& sentence, Proposals& proposals) {
    const bool to =
        sentence.is(0, {"to"}) && sentence.is(1, {"push", "press", "pull", "lift", "move", "turn"});
    const bool doing =
        sentence.is(0, {"pushing", "pressing", "pulling", "lifting", "moving", "turning"});
    if ((!to && !doing) || sentence.has_verb_from(to ? 2 : 1) || sentence.asks()) {
        return;
    }
    bool at_place = sentence.is(1, {"near", "far", "at", "on", "close"});
    for (int i = 2; i < sentence.size(); ++i) {
        const bool more = sentence.is(i, {"more"}) && sentence.is(i + 1, {"difficult"});
        const bool than = sentence.is(more ? i + 2 : i + 1, {"than"});
        if ((more || sentence.is(i, {"easier", "harder"})) && !sentence[i - 1].before_stop &&
            (than || (doing && at_place && sentence.ends_at(i)))) {
            proposals.insert(i, ErrorCode::missing_verb, "is");
            return;
        }
        at_place = at_place || sentence.is(i, {"near", "far", "from", "at", "on", "close"});
    }
}

/// What the distance of Venus? How big the Earth?
void find_missing_in_question(const FreeSentence& sentence, Proposals& proposals) {
    const bool what = sentence.is(0, {"what", "where", "who"});
    const bool how = sentence.is(0, {"how"}) && is_physical(sentence.text(1));
    const int at = what ? 1 : 2;
    const bool named = sentence.is(at, {"the"}) || (how && is_planet(sentence.text(at)));
    if (!sentence.asks() || (!what && !how) || !named || sentence.has_verb_from(0)) {
        return;
    }
    for (int i = at; i < sentence.size(); ++i) {
        // A verb of another kind, or none that is seen: "What the boy said?"
        if (sentence[i].verb_count > sentence[i].noun_count ||
            sentence[i].before_stop != (i + 1 == sentence.size())) {
            return;
        }
    }
    proposals.insert(at, ErrorCode::missing_verb, "is");
}

/// "Near the side the arm longer": where it is so stands first.
void find_missing_at_place(const FreeSentence& sentence, Proposals& proposals) {
    const int last = sentence.size() - 1;
    if (!sentence.is(0, {"at", "near", "on", "in", "far", "close"}) || sentence.asks() ||
        sentence[last].degree != Degree::comparative || !is_physical(sentence[last].adjective) ||
        sentence.has_verb_from(0)) {
        return;
    }
    for (int i = 2; i < last; ++i) {
        if (noun_phrase_at(sentence, i).last == last &&
            (sentence.is(i, {"the"}) || is_possessive(sentence.text(i))) &&
            !sentence[last - 1].before_stop) {
            proposals.insert(last, ErrorCode::missing_verb, "is");
            return;
        }
    }
}

}  // namespace

void find_verbless_clauses(const FreeSentence& sentence, Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_missing_behind(sentence, i, proposals);
    }
    find_missing_between(sentence, proposals);
    find_missing_behind_doing(sentence, proposals);
    find_missing_at_place(sentence, proposals);
    find_missing_in_question(sentence, proposals);
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
