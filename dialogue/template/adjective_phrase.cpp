// An adjective in any of its degrees, right and wrong: a fixed one, or any word of a list.
#include "dialogue/english/letters.h"
#include "dialogue/template/phrases.h"

#include <array>

namespace fulcrum::dialogue {
namespace {

/// Said before a comparative, rightly.
constexpr std::array<std::string_view, 9> kBeforeComparative = {
    "way", "a little bit", "much", "far", "a lot", "a bit", "a little", "slightly", "even"};
/// Said before a plain adjective, rightly. None of them turns its meaning round.
constexpr std::array<std::string_view, 12> kBeforePositive = {
    "very", "very very", "quite", "pretty",       "rather", "a bit",
    "both", "a little",  "so",    "a little bit", "also",   "slightly"};

/// An article that the template doesn't have: "metal is a hard". Whether "the" before a higher degree is right depends
/// on what follows (resolve.h), so it counts as part of the form.
void add_own_article(ArcWriter& writer, Degree degree, int from, int to) {
    Element article{Role::determiner};
    article.target = true;
    article.degree = degree;
    const int determiner = writer.add_element(std::move(article));
    if (degree != Degree::positive) {
        writer.add_arc(from, to, determiner, {"the", "the"});
        return;
    }
    for (const std::string_view said : {"a", "an", "the"}) {
        writer.add_arc(from, to, determiner, {said, "", ErrorCode::extra_determiner, kSlipCost});
    }
}

/// One of `modifiers`; behind an article none that has its own: "the slightly heavier one", not "the a bit heavier one".
template <class Table>
void add_modifiers_of(ArcWriter& writer, const Table& modifiers, bool after_article, int modifier,
                      int from, int to) {
    for (const std::string_view said : modifiers) {
        if (after_article && said.starts_with("a ")) {
            writer.add_arc(from, to, modifier,
                           {said, "slightly", ErrorCode::wrong_adverb, kSlipCost});
        } else {
            writer.add_arc(from, to, modifier, {said, said});
        }
    }
}

void add_modifiers(ArcWriter& writer, Degree degree, bool after_article, int from, int to) {
    const int modifier = writer.add_element({Role::modifier});
    if (degree == Degree::comparative) {
        add_modifiers_of(writer, kBeforeComparative, after_article, modifier, from, to);
        writer.add_arc(from, to, modifier, {"very", "much", ErrorCode::wrong_adverb, kSlipCost});
    } else if (degree == Degree::positive) {
        add_modifiers_of(writer, kBeforePositive, after_article, modifier, from, to);
        writer.add_arc(from, to, modifier, {"much", "very", ErrorCode::wrong_adverb, kSlipCost});
    }
}

}  // namespace

void add_degree(ArcWriter& writer, const WordList& words, int slot, Degree degree,
                bool after_article, int from, int to) {
    int start = from;
    if (!after_article || degree != Degree::superlative) {
        start = writer.add_node();
        writer.join(from, start);
    }
    if (!after_article) {
        add_own_article(writer, degree, from, start);
    }
    add_modifiers(writer, degree, after_article, from, start);

    for (std::size_t i = 0; i < words.items.size() && !writer.full(); ++i) {
        const std::vector<Noun>& spoken = words.items[i].spoken;
        for (const Noun& word : spoken) {
            Element element{Role::adjective};
            element.slot = slot;
            element.base = lower_case(word.text);
            element.degree = degree;
            element.target = true;
            const std::string base = element.base;
            const int place = writer.add_element(std::move(element));
            const std::vector<std::string> right = degree_forms(base, degree);
            for (const std::string& form : right) {
                const bool canonical = &form == right.data() && &word == spoken.data();
                writer.add_arc(start, to, place,
                               {form, form, ErrorCode::none, 0, canonical, static_cast<int>(i)});
            }
            for (const LearnerForm& wrong : learner_forms(base, degree)) {
                writer.add_arc(start, to, place,
                               {wrong.text, right.front(), wrong.code, wrong.slip * kSlipCost,
                                false, static_cast<int>(i)});
            }
        }
    }
}

int add_of_all(ArcWriter& writer, OneToo one, int from) {
    const int noun = writer.add_node();
    const int to = writer.add_node();
    writer.join(from, noun);
    writer.join(noun, to);
    if (one == OneToo::yes) {
        writer.add_arc(from, noun, writer.add_element({Role::word}), {"one", "one"});
    }
    const int of = writer.add_element({Role::word});
    for (const std::string_view said :
         {"of all", "of them", "of them all", "of all of them", "of the three", "of the four"}) {
        writer.add_arc(noun, to, of, {said, said});
    }
    return to;
}

int add_than_is(ArcWriter& writer, int from) {
    const int to = writer.add_node();
    writer.join(from, to);
    const int is = writer.add_element({Role::word});
    for (const std::string_view said : {"is", "are"}) {
        writer.add_arc(from, to, is, {said, ""});
    }
    return to;
}

int add_late_is(ArcWriter& writer, int from) {
    const int to = writer.add_node();
    writer.join(from, to);
    const int late = writer.add_element({Role::word});
    for (const std::string_view said : {"is", "are"}) {
        writer.add_arc(from, to, late, {said, "", ErrorCode::word_order, kSlipCost});
    }
    return to;
}

}  // namespace fulcrum::dialogue
