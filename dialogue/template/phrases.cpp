#include "dialogue/template/phrases.h"

#include "dialogue/english/variant.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {

struct Confusion {
    std::string_view right;
    std::array<std::string_view, 6> said;
};
/// Small words that learners put for others.
constexpr std::array kConfusions = {
    Confusion{"than", {"then", "that", "as", "of", "from", "to"}},
    Confusion{"of", {"by", "from", "in", "for", "with", ""}},
    Confusion{"in", {"on", "at", "of", "", "", ""}},
    Confusion{"on", {"in", "at", "", "", "", ""}},
    Confusion{"at", {"in", "on", "", "", "", ""}},
    Confusion{"by", {"from", "with", "of", "", "", ""}},
    Confusion{"from", {"of", "by", "with", "", "", ""}},
    Confusion{"with", {"by", "of", "from", "", "", ""}},
    Confusion{"to", {"at", "for", "", "", "", ""}},
    Confusion{"as", {"than", "like", "so", "", "", ""}},
};

const Confusion* find_confusion(std::string_view word) {
    const auto* const found =
        std::find_if(kConfusions.begin(), kConfusions.end(),
                     [&](const Confusion& entry) { return entry.right == word; });
    return found == kConfusions.end() ? nullptr : found;
}

/// "This spaceship" where the template has "the spaceship"; "these spaceship" is wrong.
void add_demonstratives(ArcWriter& writer, SubjectNumber noun, int determiner, int from, int to) {
    if (noun == SubjectNumber::unknown) {
        return;
    }
    if (noun == SubjectNumber::name) {
        for (const std::string_view said : {"this", "that"}) {
            writer.add_arc(from, to, determiner,
                           {said, "the", ErrorCode::wrong_determiner, kSlipCost});
        }
        return;
    }
    constexpr std::array<std::string_view, 2> kOne = {"this", "that"};
    constexpr std::array<std::string_view, 2> kMany = {"these", "those"};
    const bool one = noun == SubjectNumber::singular;
    for (std::size_t i = 0; i < kOne.size(); ++i) {
        const std::string_view right = one ? kOne[i] : kMany[i];
        const std::string_view wrong = one ? kMany[i] : kOne[i];
        writer.add_arc(from, to, determiner, {right, right});
        writer.add_arc(from, to, determiner,
                       {wrong, right, ErrorCode::wrong_determiner, kSlipCost});
    }
}

/// "Metal is hard": a material may have "the" or "this" before it; the node behind that.
int add_free_determiner(ArcWriter& writer, int from) {
    const int to = writer.add_node();
    writer.join(from, to);
    const int determiner = writer.add_element({Role::determiner});
    writer.add_arc(from, to, determiner, {"the", "the"});
    add_demonstratives(writer, SubjectNumber::singular, determiner, from, to);
    return to;
}

/// Feel with an adjective takes no preposition; and what felt hard may be told so.
void add_feel(ArcWriter& writer, std::string_view word, int verb, int from, int to) {
    const int past = writer.add_element({Role::word});
    writer.add_arc(from, to, past, {"felt", "felt"});
    for (const std::string_view said : {"feels like", "feel like"}) {
        writer.add_arc(from, to, verb, {said, word, ErrorCode::extra_preposition, kSlipCost});
    }
}

void add_verb(ArcWriter& writer, std::string_view word, const VerbForms& forms, Neighbours near,
              int from, int to) {
    const int start = near.after_list ? add_repeated_subject(writer, from) : from;
    Element element{Role::verb};
    element.verb = forms;
    const int verb = writer.add_element(std::move(element));
    const std::string& other = forms.singular == word ? forms.plural : forms.singular;
    writer.add_arc(start, to, verb, {word, word, ErrorCode::none, 0, true});
    writer.add_arc(start, to, verb, {other, word, ErrorCode::agreement, kSlipCost});
    for (const LearnerVerb& wrong : learner_verbs(forms)) {
        if (wrong.text != word) {
            writer.add_arc(start, to, verb, {wrong.text, word, wrong.code, kPatternCost});
        }
    }
    if (forms.is_be) {
        writer.add_arc(start, to, verb, {"", word, ErrorCode::missing_verb, kPatternCost});
    }
    if (word == "is" || word == "are") {
        add_past_of_be(writer, Element{Role::verb}, word, false, start, to);
    }
    if (forms.plural == "feel" && near.before_adjective) {
        add_feel(writer, word, verb, start, to);
    }
}

/// "and" between two adjectives: "hard but smooth" and "hard and it is smooth" are right too.
void add_and(ArcWriter& writer, int from, int to) {
    const int conjunction = writer.add_element({Role::conjunction});
    writer.add_arc(from, to, conjunction, {"and", "and", ErrorCode::none, 0, true});
    for (const std::string_view said :
         {"but", "and also", "but also", "and it is", "and they are", "and it feels",
          "and they feel", "and is", "and are", "and feels", "and feel"}) {
        writer.add_arc(from, to, conjunction, {said, said});
    }
    // Two sentences, one behind the other.
    writer.add_arc(from, to, conjunction, {"it is", "and it is"});
    writer.add_arc(from, to, conjunction, {"they are", "and they are"});
    for (const std::string_view said : {"or", "with", "of"}) {
        writer.add_arc(from, to, conjunction,
                       {said, "and", ErrorCode::wrong_conjunction, kPatternCost});
    }
    for (const std::string_view said : {"end", "an", "ad"}) {
        writer.add_arc(from, to, conjunction, {said, "and", ErrorCode::spelling, kSlipCost});
    }
    writer.add_arc(from, to, conjunction, {"", "and", ErrorCode::missing_conjunction, kSlipCost});
}

}  // namespace

int add_repeated_subject(ArcWriter& writer, int from) {
    const int to = writer.add_node();
    writer.join(from, to);
    const int pronoun = writer.add_element({Role::pronoun});
    for (const std::string_view said : {"it", "they"}) {
        writer.add_arc(from, to, pronoun, {said, "", ErrorCode::extra_pronoun, kSlipCost});
    }
    return to;
}

void add_past_of_be(ArcWriter& writer, Element element, std::string_view present, bool is_either,
                    int from, int to) {
    element.verb = {"was", "were", true};
    const int past = writer.add_element(std::move(element));
    const bool is_one = present == "is";
    const std::string_view own = is_one ? "was" : "were";
    const std::string_view other = is_one ? "were" : "was";
    writer.add_arc(from, to, past, {own, own});
    if (is_either) {
        writer.add_arc(from, to, past, {other, other});
    } else {
        writer.add_arc(from, to, past, {other, own, ErrorCode::agreement, kSlipCost});
    }
}

bool is_article(std::string_view word) {
    return word == "a" || word == "an" || word == "the";
}

void add_word(ArcWriter& writer, std::string_view word, std::string_view shown, Neighbours near,
              int from, int to) {
    if (is_article(word)) {
        add_article(writer, word, near.noun, from, to);
        return;
    }
    // Behind "a {size}" comes a noun: "a stronger pull".
    if (VerbForms forms; !near.in_phrase && understand_verb(word, forms)) {
        add_verb(writer, word, forms, near, from, to);
        return;
    }
    if (word == "and" && near.after_adjective && near.before_adjective) {
        add_and(writer, from, to);
        return;
    }
    const Confusion* confusion = find_confusion(word);
    if (confusion == nullptr) {
        from = near.begins_phrase && is_mass_noun(word) ? add_free_determiner(writer, from) : from;
        const int place = writer.add_element({Role::word});
        writer.add_arc(from, to, place, {word, shown, ErrorCode::none, 0, true});
        if (const std::string other = other_spelling(word); !other.empty()) {
            writer.add_arc(from, to, place, {other, other});
        }
        return;
    }
    const int preposition = writer.add_element({Role::preposition});
    writer.add_arc(from, to, preposition, {word, shown, ErrorCode::none, 0, true});
    for (const std::string_view said : confusion->said) {
        if (!said.empty()) {
            // "harder that metal": rather a slip of "than" than "that metal" without it.
            const int cost = word == "than" && said == "that" ? kSlipCost : kPatternCost;
            writer.add_arc(from, to, preposition,
                           {said, shown, ErrorCode::wrong_preposition, cost});
        }
    }
    writer.add_arc(from, to, preposition,
                   {"", shown, ErrorCode::missing_preposition, kPatternCost});
}

bool is_demonstrative(std::string_view word) {
    return word == "this" || word == "that" || word == "these" || word == "those";
}

bool is_preposition(std::string_view word) {
    return find_confusion(word) != nullptr;
}

void add_article(ArcWriter& writer, std::string_view word, SubjectNumber noun, int from, int to) {
    const int determiner = writer.add_element({Role::determiner});
    add_demonstratives(writer, noun, determiner, from, to);
    if (word.empty()) {
        for (const std::string_view said : {"a", "an", "the", ""}) {
            writer.add_arc(from, to, determiner, {said, said, ErrorCode::none, 0, said.empty()});
        }
        return;
    }
    writer.add_arc(from, to, determiner, {word, word, ErrorCode::none, 0, true});
    for (const std::string_view said : {"a", "an", "the"}) {
        if (said != word) {
            writer.add_arc(from, to, determiner,
                           {said, word, ErrorCode::wrong_determiner, kSlipCost});
        }
    }
    writer.add_arc(from, to, determiner, {"", word, ErrorCode::missing_determiner, kSlipCost});
}

void add_it(ArcWriter& writer, SubjectNumber number, int from, int to) {
    constexpr std::array<std::string_view, 3> kOne = {"it", "this", "that"};
    constexpr std::array<std::string_view, 3> kMany = {"they", "these", "those"};
    const int place = writer.add_element({Role::noun});
    const bool is_many = number == SubjectNumber::plural;
    const std::string_view own = is_many ? "they" : "it";
    ArcText missing{"", own, ErrorCode::missing_pronoun, kPatternCost};
    missing.number = is_many ? Number::plural : Number::singular;
    writer.add_arc(from, to, place, missing);
    for (const bool many : {false, true}) {
        const bool wrong = number != SubjectNumber::unknown && many != is_many;
        for (std::size_t i = 0; i < kOne.size(); ++i) {
            const std::string_view said = many ? kMany[i] : kOne[i];
            ArcText arc{said, said, ErrorCode::none, 0, said == own};
            if (wrong) {
                arc = {said, many ? kOne[i] : kMany[i], ErrorCode::wrong_pronoun, kSlipCost};
            }
            arc.number = many != wrong ? Number::plural : Number::singular;
            writer.add_arc(from, to, place, arc);
        }
    }
}

void add_kind(ArcWriter& writer, std::string_view article, std::string_view noun, int from,
              int to) {
    const std::string plural = plural_of(noun);
    if (is_mass_noun(noun) || looks_plural(noun) || plural == noun) {
        return;
    }
    Element element{Role::noun};
    element.brings_article = true;
    const std::string_view own = article == "the" ? article : indefinite_article(noun);
    const std::string right = std::string(own) + " " + std::string(noun);
    writer.add_arc(from, to, writer.add_element(std::move(element)),
                   {plural, right, ErrorCode::noun_number, kKindCost});
}

void add_plural(ArcWriter& writer, std::string_view noun, bool after_list, int from, int to) {
    Element element{Role::noun};
    element.base = std::string(noun);
    element.target = true;
    const int place = writer.add_element(std::move(element));
    const std::string right = plural_of(noun);
    ArcText arc{right, right, ErrorCode::none, 0, true};
    arc.number = Number::plural;
    writer.add_arc(from, to, place, arc);
    if (after_list) {
        writer.add_arc(from, to, place, {"", ""});
    }
    if (right != noun) {
        arc = {noun, right, ErrorCode::noun_number, kSlipCost};
        arc.number = Number::plural;
        writer.add_arc(from, to, place, arc);
    }
    for (const std::string& wrong : learner_plurals(noun)) {
        arc = {wrong, right, ErrorCode::noun_inflection, kSlipCost};
        arc.number = Number::plural;
        writer.add_arc(from, to, place, arc);
    }
}

}  // namespace fulcrum::dialogue
