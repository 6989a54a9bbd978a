// Errors of "is made of" in a free sentence.
#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/checking/proposal.h"
#include "dialogue/english/making.h"

#include <algorithm>

// Each rule is one chain of conditions, told in the order in which the grammar has them.
// NOLINTBEGIN(readability-function-cognitive-complexity,bugprone-branch-clone)
namespace fulcrum::dialogue {
namespace {

bool is_of(const FreeSentence& sentence, int i) {
    return sentence.is(i, {"of", "from", "out"});
}

/// A material that ends its phrase at `i`, or behind an article there; its place, or -1.
int material_at(const FreeSentence& sentence, int i) {
    i += sentence.is(i, {"a", "an", "the"}) ? 1 : 0;
    const FreeWord& word = sentence[i];
    const bool material = is_material(word.text) || is_material(word.singular);
    return material && sentence.is_head(i) ? i : -1;
}

/// is make of, is maked of, is making from.
void find_participle(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (!sentence.be_at(i) && !sentence.is(i, {"be", "been"})) {
        return;
    }
    for (const LearnerVerb& wrong : learner_participles()) {
        const bool said = sentence.text(i + 1) == wrong.text && !sentence[i].before_stop;
        const bool with_preposition = is_of(sentence, i + 2) || sentence.is(i + 2, {"by", "with"});
        if (said && with_preposition && material_at(sentence, i + 3) >= 0) {
            proposals.replace(i + 1, wrong.code, "made");
        } else if (said && is_of(sentence, i + 2)) {
            proposals.replace(i + 1, wrong.code, "made");
        }
    }
}

/// made by metal, made with wood, made metal.
void find_preposition(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool passive = sentence.is(i, {"made", "make", "makes", "maked"}) &&
                         !sentence[i].before_stop &&
                         (sentence.be_at(i - 1) || sentence[i - 1].mainly_noun() ||
                          sentence.is(i - 1, {"not", "be", "something"}));
    if (!passive) {
        return;
    }
    if (sentence.is(i + 1, {"by", "with", "in", "for"}) && material_at(sentence, i + 2) >= 0) {
        proposals.replace(i + 1, ErrorCode::wrong_preposition, "of");
    } else if ((sentence.be_at(i - 1) || sentence.is(i - 1, {"be", "not", "something"})) &&
               sentence.is(i, {"made"}) && material_at(sentence, i + 1) == i + 1) {
        proposals.insert(i + 1, ErrorCode::missing_preposition, "of");
    }
}

/// a spaceship made of metal; a spaceship makes of metal.
void find_auxiliary(const FreeSentence& sentence, Proposals& proposals) {
    const NounPhrase subject = noun_phrase_at(sentence, 0);
    const int at = subject.last;
    const bool pronoun =
        subject.first == subject.last && (sentence.is(0, {"it", "they", "this", "these"}));
    const int made = pronoun ? 1 : at;
    const bool whole = (pronoun || at > 0) && is_of(sentence, made + 1);
    if (!whole) {
        return;
    }
    const int of = sentence.is(made + 1, {"out"}) ? made + 2 : made + 1;
    int named = of + 1;
    while (!is_material(sentence.text(named)) &&
           (sentence[named].mainly_adjective() || is_physical(sentence.text(named)))) {
        ++named;  // "of thick paper"
    }
    const int material = material_at(sentence, named);
    const bool plural =
        pronoun ? sentence.is(0, {"they", "these"}) : subject.number == Number::plural;
    const std::string be = plural ? "are" : "is";
    const bool ends = material >= 0 && material + 1 >= sentence.size();
    // "It made of cloth", of whatever that is.
    const bool surely = pronoun && sentence.is(1, {"made"}) && sentence.is(2, {"of"});
    if (!ends && !surely) {
        return;
    }
    if (sentence.is(made, {"made"})) {
        proposals.insert(made, ErrorCode::missing_verb, be);
    } else if (sentence.is(made, {"makes", "make"})) {
        proposals.replace(made, ErrorCode::verb_voice, be + " made");
    }
}

/// made of the metal; "made of a metal" has its rule among the articles.
void find_the_material(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool made = sentence.is(i, {"made"}) && sentence.be_at(i - 1);
    if (made && sentence.is(i + 1, {"of"}) && sentence.is(i + 2, {"the"}) &&
        is_material(sentence.text(i + 3)) && sentence.ends_at(i + 3)) {
        proposals.replace(i + 2, ErrorCode::extra_determiner, "");
    }
}

/// maked, wherever it stands.
void find_maked(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool behind_be = sentence.be_at(i - 1) || sentence.is(i - 1, {"be", "been"});
    if (sentence.is(i, {"maked", "maded"}) && !(behind_be && is_of(sentence, i + 1))) {
        proposals.replace(i, ErrorCode::verb_inflection, "made");
    }
}

}  // namespace

void find_making_errors(const FreeSentence& sentence, Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_participle(sentence, i, proposals);
        find_preposition(sentence, i, proposals);
        find_the_material(sentence, i, proposals);
        find_maked(sentence, i, proposals);
    }
    find_auxiliary(sentence, proposals);
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
