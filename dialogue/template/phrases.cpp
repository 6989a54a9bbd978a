#include "dialogue/template/phrases.h"

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

/// Said before a comparative, rightly.
constexpr std::array<std::string_view, 9> kModifiers = {
    "way", "a little bit", "much", "far", "a lot", "a bit", "a little", "slightly", "even"};

void add_verb(ArcWriter& writer, std::string_view word, const VerbForms& forms, bool after_noun,
              int from, int to) {
    int start = from;
    if (after_noun) {
        start = writer.add_node();
        writer.join(from, start);
        const int pronoun = writer.add_element({Role::pronoun});
        for (const std::string_view said : {"it", "they"}) {
            writer.add_arc(from, start, pronoun, {said, "", ErrorCode::extra_pronoun, kSlipCost});
        }
    }
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
}

}  // namespace

bool is_article(std::string_view word) {
    return word == "a" || word == "an" || word == "the";
}

void add_word(ArcWriter& writer, std::string_view word, std::string_view shown, bool after_noun,
              int from, int to) {
    if (is_article(word)) {
        add_article(writer, word, from, to);
        return;
    }
    if (VerbForms forms; understand_verb(word, forms)) {
        add_verb(writer, word, forms, after_noun, from, to);
        return;
    }
    const auto* confusion =
        std::find_if(kConfusions.begin(), kConfusions.end(),
                     [&](const Confusion& entry) { return entry.right == word; });
    if (confusion == kConfusions.end()) {
        writer.add_arc(from, to, writer.add_element({Role::word}),
                       {word, shown, ErrorCode::none, 0, true});
        return;
    }
    const int preposition = writer.add_element({Role::preposition});
    writer.add_arc(from, to, preposition, {word, shown, ErrorCode::none, 0, true});
    for (const std::string_view said : confusion->said) {
        if (!said.empty()) {
            writer.add_arc(from, to, preposition,
                           {said, shown, ErrorCode::wrong_preposition, kPatternCost});
        }
    }
    writer.add_arc(from, to, preposition,
                   {"", shown, ErrorCode::missing_preposition, kPatternCost});
}

void add_article(ArcWriter& writer, std::string_view word, int from, int to) {
    const int determiner = writer.add_element({Role::determiner});
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

void add_degree(ArcWriter& writer, std::string_view adjective, Degree degree, bool after_article,
                int from, int to) {
    // Before the adjective: an article that the template leaves out, or "much" before a comparative.
    int start = from;
    if (!after_article || degree == Degree::comparative) {
        start = writer.add_node();
        writer.join(from, start);
    }
    if (!after_article) {
        // Marked as part of the form: whether "the" is right depends on what follows (resolve.h).
        Element article{Role::determiner};
        article.target = true;
        writer.add_arc(from, start, writer.add_element(std::move(article)), {"the", "the"});
    }
    if (degree == Degree::comparative) {
        const int modifier = writer.add_element({Role::modifier});
        for (const std::string_view said : kModifiers) {
            writer.add_arc(from, start, modifier, {said, said});
        }
        writer.add_arc(from, start, modifier, {"very", "much", ErrorCode::wrong_adverb, kSlipCost});
    }

    // The adjective itself, right and wrong.
    Element element{Role::adjective};
    element.base = std::string(adjective);
    element.degree = degree;
    element.target = true;
    const int place = writer.add_element(std::move(element));
    const std::vector<std::string> right = degree_forms(adjective, degree);
    for (const std::string& form : right) {
        writer.add_arc(start, to, place, {form, form, ErrorCode::none, 0, &form == right.data()});
    }
    for (const LearnerForm& wrong : learner_forms(adjective, degree)) {
        writer.add_arc(start, to, place,
                       {wrong.text, right.front(), wrong.code, wrong.slip * kSlipCost});
    }
}

void add_plural(ArcWriter& writer, std::string_view noun, int from, int to) {
    Element element{Role::noun};
    element.base = std::string(noun);
    element.target = true;
    const int place = writer.add_element(std::move(element));
    const std::string right = plural_of(noun);
    ArcText arc{right, right, ErrorCode::none, 0, true};
    arc.number = Number::plural;
    writer.add_arc(from, to, place, arc);
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
