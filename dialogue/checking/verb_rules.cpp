// Errors of a verb's form in a free sentence: one too many, a plain one, one without "do", and what it turns back to.
#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/checking/proposal.h"

// Each rule is one chain of conditions, told in the order in which the grammar has them.
// NOLINTBEGIN(readability-function-cognitive-complexity,bugprone-branch-clone)
namespace fulcrum::dialogue {
namespace {

/// it be heavy, the weight being stronger: a plain form where a finite one belongs.
void find_plain_be(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!sentence.is(i, {"be", "being"}) || i == 0 || sentence[i].behind_stop) {
        return;
    }
    const std::string& before = sentence.text(i - 1);
    if (sentence.be_at(i - 1) && sentence.is(i, {"be"})) {
        proposals.replace(i, ErrorCode::verb_form, "");
        return;
    }
    if (before == "there" && i == 1) {
        const bool many = sentence[i + 1].number || sentence[i + 1].plural_noun();
        proposals.replace(i, ErrorCode::verb_form, many ? "are" : "is");
        return;
    }
    const bool pronoun = (is_third_singular(before) || is_other_person(before)) &&
                         sentence.clause_begins(i - 1) &&
                         !sentence.is(i - 2, {"if", "that", "though"});
    const NounPhrase subject = noun_phrase_at(sentence, 0);
    const bool noun = subject.last == i && subject.determined && sentence.is(i, {"be"});
    if (pronoun) {
        proposals.replace(i, ErrorCode::verb_form,
                          before == "i"               ? "am"
                          : is_third_singular(before) ? "is"
                                                      : "are");
    } else if (noun) {
        proposals.replace(i, ErrorCode::verb_form, subject.number == Number::plural ? "are" : "is");
    }
}

/// must is go, you are push it: one verb too many.
void find_extra_be(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!sentence.is(i, {"is", "are"}) || i == 0 || sentence[i].behind_stop ||
        sentence[i].before_stop) {
        return;
    }
    const FreeWord& verb = sentence[i + 1];
    const bool plain = (verb.closed ? sentence.is(i + 1, {"have", "do"})
                                    : verb.mainly_verb() && verb.adjective_count == 0) &&
                       verb.verb_plain && !verb.verb_in_s && !is_same_in_past(verb.verb) &&
                       !sentence.is(i + 1, {"come", "become", "run", "overcome"});
    // "It is lift", "it is drag of the line": rather a thing than what is done.
    const bool acts =
        verb.noun_count == 0 ||
        !(sentence.ends_at(i + 1) || sentence.is(i + 2, {"of", "in", "from", "what", "that",
                                                         "which", "who", "because", "and"}));
    const bool subject =
        (is_third_singular(sentence.text(i - 1)) || is_other_person(sentence.text(i - 1))) &&
        sentence.clause_begins(i - 1);
    const bool modal = is_modal(sentence.text(i - 1)) && !sentence[i - 1].behind_stop;
    if (plain && ((acts && subject) || modal) && !sentence.asks()) {
        proposals.replace(i, ErrorCode::verb_form, "");
    }
}

/// must to make, can to fly.
void find_to_behind_modal(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool modal = sentence.is(i, {"must", "can", "cannot", "could", "should"});
    const FreeWord& before = sentence[i - 1];  // "a garbage can to fill"
    const bool subject = is_third_singular(before.text) || is_other_person(before.text) ||
                         before.thing || (!sentence.is(i, {"can"}) && before.noun_count > 0);
    if (modal && i > 0 && subject && !sentence[i].before_stop && sentence.is(i + 1, {"to"}) &&
        sentence[i + 2].verb_plain &&
        (sentence[i + 2].verb_count > sentence[i + 2].noun_count ||
         sentence.is(i + 2, {"have", "be", "do"}))) {
        proposals.replace(i + 1, ErrorCode::extra_preposition, "");
    }
}

/// What is had, needed or done; not what may be "not": "it not only pulls".
bool is_denied_verb(const FreeSentence& sentence, int i) {
    return sentence.is(i, {"have", "need"}) || (sentence[i].verb_plain && !sentence[i].verb_in_s &&
                                                !sentence[i].closed && sentence[i].mainly_verb());
}

/// it not have a tail, it no have wind, the kite not fly: "do" is missing.
void find_missing_do(const FreeSentence& sentence, int i, Proposals& proposals) {
    const std::string& subject = sentence.text(i - 1);
    const bool third = is_third_singular(subject);
    if (!sentence.is(i, {"not", "no"}) || i == 0 || sentence[i].behind_stop ||
        sentence[i].before_stop || sentence.asks() || !is_denied_verb(sentence, i + 1)) {
        return;
    }
    const bool pronoun = (third || is_other_person(subject)) && sentence.clause_begins(i - 1) &&
                         !sentence.is(i - 2, {"if", "that", "though"});
    const NounPhrase phrase = noun_phrase_at(sentence, 0);
    const bool noun = phrase.last == i && phrase.determined && phrase.sure;
    if (pronoun || noun) {
        const bool one = pronoun ? third : phrase.number == Number::singular;
        proposals.replace(i, ErrorCode::verb_form, one ? "does not" : "do not");
    }
}

/// it turns around himself.
void find_himself(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!sentence.is(i, {"himself", "herself"})) {
        return;
    }
    int it = -1;
    for (int at = 0; at < i; ++at) {
        const FreeWord& word = sentence[at];
        if (is_other_person(word.text) || sentence.is(at, {"he", "she", "him", "her", "who"}) ||
            (word.capital && at > 0)) {
            return;
        }
        it = sentence.is(at, {"it"}) || word.thing ? at : it;
        // "The pilot of it", and any other that it could be.
        if (word.noun_count > 0 && !word.closed && !word.thing && word.mainly_noun()) {
            return;
        }
    }
    if (it >= 0) {
        proposals.replace(i, ErrorCode::wrong_pronoun, "itself");
    }
}

/// does not likes, can goes, did it has.
void find_after_auxiliary(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool help = sentence.is(i, {"do", "does", "did"});
    if ((!help && !is_modal(sentence.text(i))) || sentence[i].before_stop) {
        return;
    }
    int at = i + 1;
    const bool has_not = sentence.is(at, {"not"});
    at += has_not ? 1 : 0;
    const bool turned = is_third_singular(sentence.text(at)) || is_other_person(sentence.text(at));
    if (turned && !(i == 0 || is_question_word(sentence.text(i - 1)) || sentence[i].behind_stop)) {
        return;
    }
    at += turned ? 1 : 0;
    const FreeWord& verb = sentence[at];
    const bool sure_verb = sentence.is(at, {"has", "does", "is"})
                               ? (has_not || turned || is_modal(sentence.text(i)))
                               : verb.verb_in_s && verb.mainly_verb() && !verb.closed;
    if (sentence[at - 1].before_stop || !verb.verb_in_s || !sure_verb || verb.possessive) {
        return;
    }
    const std::string plain = verb.text == "is" ? "be" : verb.verb;
    if (plain != verb.text) {
        proposals.replace(at, ErrorCode::verb_form, plain);
    }
}

}  // namespace

void find_verb_form_errors(const FreeSentence& sentence, Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_after_auxiliary(sentence, i, proposals);
        find_plain_be(sentence, i, proposals);
        find_extra_be(sentence, i, proposals);
        find_missing_do(sentence, i, proposals);
        find_himself(sentence, i, proposals);
        find_to_behind_modal(sentence, i, proposals);
    }
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
