// "is made of metal": the auxiliary, the participle, the preposition and the material, each with what learners say there,
// and the active verb that learners put for all three.
//
//   --is--> --made--> --of--> --metal-->
//     are R:VERB:SVA (settled by the subject, resolve.h) · nothing M:VERB · make R:VERB:FORM · maked R:VERB:INFL
//   --makes R:VERB:VOICE----> --by R:PREP--> --a U:DET metal-->
#include "dialogue/english/letters.h"
#include "dialogue/english/making.h"
#include "dialogue/template/phrases.h"

namespace fulcrum::dialogue {
namespace {

constexpr int kVoiceCost = 30;  // below that of a missing "is" and a wrong form of "made" together

Element passive_element(Role role) {
    Element element{role};
    element.passive = true;
    element.target = true;
    return element;
}

void add_auxiliary(ArcWriter& writer, SubjectNumber subject, int from, int to) {
    Element element = passive_element(Role::verb);
    element.verb = {"is", "are", true};
    const int verb = writer.add_element(std::move(element));
    const bool plural = subject == SubjectNumber::plural;
    const std::string_view own = plural ? "are" : "is";
    const std::string_view other = plural ? "is" : "are";
    writer.add_arc(from, to, verb, {own, own, ErrorCode::none, 0, true});
    if (subject == SubjectNumber::unknown) {
        writer.add_arc(from, to, verb, {other, other});
    } else {
        writer.add_arc(from, to, verb, {other, own, ErrorCode::agreement, kSlipCost});
    }
    for (const LearnerVerb& wrong : learner_auxiliaries()) {
        writer.add_arc(from, to, verb, {wrong.text, own, wrong.code, kPatternCost});
    }
    writer.add_arc(from, to, verb, {"", own, ErrorCode::missing_verb, kPatternCost});
    add_past_of_be(writer, passive_element(Role::verb), own, subject == SubjectNumber::unknown,
                   from, to);
}

void add_active(ArcWriter& writer, SubjectNumber subject, int from, int to) {
    Element element = passive_element(Role::verb);
    element.verb = {"is made", "are made", false};
    const int verb = writer.add_element(std::move(element));
    const std::string_view right = subject == SubjectNumber::plural ? "are made" : "is made";
    for (const LearnerVerb& wrong : active_for_passive()) {
        writer.add_arc(from, to, verb, {wrong.text, right, wrong.code, kVoiceCost});
    }
}

/// "The key is metal": as right as "is made of metal".
void add_without_making(ArcWriter& writer, int from, int to) {
    const int nothing = writer.add_element(passive_element(Role::word));
    writer.add_arc(from, to, nothing, {"", ""});
}

void add_participle(ArcWriter& writer, Making making, int from, int to) {
    // No agreement of its own: it follows the auxiliary, not the subject.
    const int made = writer.add_element(passive_element(Role::word));
    writer.add_arc(from, to, made, {"made", "made", ErrorCode::none, 0, true});
    for (const LearnerVerb& wrong : learner_participles()) {
        writer.add_arc(from, to, made, {wrong.text, "made", wrong.code, kPatternCost});
    }
    if (making != Making::whole) {
        writer.add_arc(from, to, made, {"", "made", ErrorCode::missing_verb, kPatternCost});
    }
}

void add_of(ArcWriter& writer, int from, int to) {
    const int preposition = writer.add_element(passive_element(Role::preposition));
    writer.add_arc(from, to, preposition, {"of", "of", ErrorCode::none, 0, true});
    for (const std::string_view said : {"out of", "up of"}) {
        writer.add_arc(from, to, preposition, {said, said});
    }
    // "from" is settled once thing and material are known (resolve.h).
    for (const std::string_view said : {"by", "from", "with", "in", "for", "to", "off", "as"}) {
        writer.add_arc(from, to, preposition,
                       {said, "of", ErrorCode::wrong_preposition, kPatternCost});
    }
    writer.add_arc(from, to, preposition, {"", "of", ErrorCode::missing_preposition, kPatternCost});
}

/// No article: "of some wood" passes and is said back without; "of a metal" and "of the metal" are wrong.
void add_article_of_material(ArcWriter& writer, int from, int to) {
    const int determiner = writer.add_element({Role::determiner});
    writer.add_arc(from, to, determiner, {"", "", ErrorCode::none, 0, true});
    for (const std::string_view said : {"some", "this", "that"}) {
        writer.add_arc(from, to, determiner, {said, ""});
    }
    for (const std::string_view said : {"a", "an", "the"}) {
        writer.add_arc(from, to, determiner, {said, "", ErrorCode::extra_determiner, kSlipCost});
    }
}

/// "Of rocks", "of bricks" is right; "of metals", "of glasses" isn't.
void add_plural_of_material(ArcWriter& writer, const Noun& word, int item, int place, int from,
                            int to) {
    const std::string plural = plural_of(word.text);
    if (word.noun_class == NounClass::plural || lower_case(plural) == lower_case(word.text)) {
        return;
    }
    if (word.noun_class == NounClass::count) {
        writer.add_arc(from, to, place,
                       {plural, plural, ErrorCode::none, 0, false, item, Number::plural});
    } else {
        writer.add_arc(from, to, place,
                       {plural, word.text, ErrorCode::noun_number, kSlipCost, false, item});
    }
}

}  // namespace

void add_material(ArcWriter& writer, const WordList& words, int slot, int from, int to) {
    const int noun = writer.add_node();
    add_article_of_material(writer, from, noun);
    Element element{Role::noun};
    element.slot = slot;
    const int place = writer.add_element(std::move(element));
    for (std::size_t i = 0; i < words.items.size() && !writer.full(); ++i) {
        const std::vector<Noun>& spoken = words.items[i].spoken;
        for (const Noun& word : spoken) {
            ArcText arc{word.text, word.text, ErrorCode::none, 0, &word == spoken.data()};
            arc.item = static_cast<int>(i);
            arc.number = word.number();
            writer.add_arc(noun, to, place, arc);
            add_plural_of_material(writer, word, arc.item, place, noun, to);
        }
    }
}

int add_made_last(ArcWriter& writer, int from) {
    const int to = writer.add_node();
    writer.join(from, to);
    const int late = writer.add_element(passive_element(Role::word));
    for (const std::string_view said : {"made", "is made", "made is"}) {
        writer.add_arc(from, to, late, {said, "", ErrorCode::word_order, kSlipCost});
    }
    return to;
}

int add_made_of(ArcWriter& writer, Neighbours near, Making making, int from) {
    const int start = near.after_list ? add_repeated_subject(writer, from) : from;
    const int auxiliary = writer.add_node();
    const int participle = writer.add_node();
    const int preposition = writer.add_node();
    // After a list resolve.h settles the number; until then it is a singular as other verbs are.
    const SubjectNumber subject = near.after_list ? SubjectNumber::singular : near.subject;
    add_auxiliary(writer, subject, start, auxiliary);
    add_participle(writer, making, auxiliary, participle);
    add_active(writer, subject, start, participle);
    add_of(writer, participle, preposition);
    if (making == Making::plain) {
        add_without_making(writer, auxiliary, preposition);
    }
    return preposition;
}

}  // namespace fulcrum::dialogue
