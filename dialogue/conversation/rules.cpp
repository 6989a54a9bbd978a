// Which of the catalogue's rules belongs to an error, and all keys that a conversation needs.
#include "dialogue/conversation/conversation.h"
#include "dialogue/english/noun.h"

#include <array>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {
namespace {

/// rule.superlative.ending, rule.comparative.more_most, …
std::string degree_rule(const FormError& error) {
    const std::string degree = error.degree == Degree::comparative ? "comparative" : "superlative";
    switch (comparison_of(error.base)) {
        case Comparison::ending:
        case Comparison::both:
            return "rule." + degree + ".ending";
        case Comparison::more_most:
            return "rule." + degree + ".more_most";
        case Comparison::irregular:
            break;
    }
    return "rule." + degree + ".irregular";
}

/// The rules of "is made of".
std::string passive_rule(const FormError& error) {
    switch (error.code) {
        case ErrorCode::agreement:
            return "rule.verb.agreement";
        case ErrorCode::verb_voice:
            return "rule.passive.voice";
        case ErrorCode::wrong_preposition:
        case ErrorCode::missing_preposition:
            return error.said == "from" ? "rule.passive.from" : "rule.passive.of";
        default:
            return error.right == "made" ? "rule.passive.made" : "rule.passive.be";
    }
}

/// The rules of a plain adjective: "metal is hardly", "metal is harder".
std::string positive_rule(const FormError& error) {
    switch (error.code) {
        case ErrorCode::morphology:
            return "rule.adjective.form";
        case ErrorCode::adjective_form:
            return "rule.adjective.degree";
        default:
            return "rule.spelling";
    }
}

/// A material takes no article and no plural.
bool is_of_material(const FormError& error) {
    const bool of_noun = error.code == ErrorCode::noun_number && error.role == Role::noun;
    return (of_noun || error.code == ErrorCode::extra_determiner) && is_mass_noun(error.phrase);
}

/// "These rock": this and that point at one thing.
bool is_of_pointing(const FormError& error) {
    return error.code == ErrorCode::wrong_determiner &&
           (error.right == "this" || error.right == "that" || error.right == "these" ||
            error.right == "those");
}

/// "Its" for "it's".
bool is_of_contraction(const FormError& error) {
    return error.code == ErrorCode::orthography && error.right.find('\'') != std::string::npos;
}

/// Rules that hold for one code, whatever the word.
constexpr std::array<std::pair<ErrorCode, std::string_view>, 23> kRules = {{
    {ErrorCode::wording, "rule.wording"},
    {ErrorCode::adjective_form, "rule.wording"},
    {ErrorCode::word_order, "rule.wording"},
    {ErrorCode::missing_determiner, "rule.article.missing"},
    {ErrorCode::wrong_determiner, "rule.article.sound"},
    {ErrorCode::extra_determiner, "rule.article.extra"},
    {ErrorCode::agreement, "rule.verb.agreement"},
    {ErrorCode::missing_verb, "rule.verb.missing"},
    {ErrorCode::verb_form, "rule.verb.form"},
    {ErrorCode::verb_tense, "rule.verb.form"},
    {ErrorCode::extra_pronoun, "rule.pronoun.extra"},
    {ErrorCode::wrong_adverb, "rule.adverb"},
    {ErrorCode::noun_number, "rule.noun.number"},
    {ErrorCode::noun_inflection, "rule.noun.plural"},
    {ErrorCode::orthography, "rule.spelling"},
    {ErrorCode::missing_pronoun, "rule.pronoun.missing"},
    {ErrorCode::wrong_pronoun, "rule.pronoun.number"},
    {ErrorCode::missing_conjunction, "rule.and"},
    {ErrorCode::wrong_conjunction, "rule.and"},
    {ErrorCode::extra_preposition, "rule.preposition.extra"},
    {ErrorCode::morphology, "rule.adjective.form"},
    {ErrorCode::verb_inflection, "rule.passive.made"},
    {ErrorCode::verb_voice, "rule.passive.voice"},
}};

std::vector<CatalogueNeed> make_needs() {
    std::vector<CatalogueNeed> needs{{"question.number", {"n", "of"}},
                                     {"list.or", {}},
                                     {"list.comma", {}},
                                     {"feedback.praise.1", {"sentence"}},
                                     {"feedback.praise.2", {"sentence"}},
                                     {"feedback.praise_question", {}},
                                     {"feedback.praise_short", {"sentence"}},
                                     {"feedback.repaired", {"sentence"}},
                                     {"feedback.recast", {"sentence"}},
                                     {"feedback.recast_question", {"sentence"}},
                                     {"feedback.prompt", {"sentence", "gap"}},
                                     {"feedback.recast_said", {"sentence"}},
                                     {"feedback.rule", {"sentence", "rule"}},
                                     {"feedback.rule_said", {"sentence", "rule"}},
                                     {"feedback.wrong_meaning", {}},
                                     {"feedback.wrong_meaning.again", {"again"}},
                                     {"feedback.other_number", {"said"}},
                                     {"feedback.other_number.again", {"said", "again"}},
                                     {"feedback.turned_round", {}},
                                     {"feedback.opposite", {"said", "asked"}},
                                     {"feedback.which_one", {}},
                                     {"feedback.not_understood.1", {}},
                                     {"feedback.not_understood.2", {"frame"}},
                                     {"feedback.not_understood.3", {"choices"}},
                                     {"feedback.not_understood.example", {"sentence"}},
                                     {"feedback.free_form", {"sentence", "then"}},
                                     {"feedback.free_words", {"right", "said", "then"}},
                                     {"feedback.free_missing", {"right", "next", "then"}},
                                     {"feedback.free_extra", {"said", "then"}},
                                     {"feedback.heard_badly", {}},
                                     {"feedback.moved_on", {}}};
    const std::vector<std::string_view> words{"base", "right", "said", "phrase"};
    for (const auto& [code, key] : kRules) {
        if (needs.back().key != key) {  // neighbours may share one
            needs.push_back({key, words});
        }
    }
    for (const std::string_view key :
         {"rule.superlative.ending", "rule.superlative.more_most", "rule.superlative.irregular",
          "rule.superlative.the", "rule.comparative.ending", "rule.comparative.more_most",
          "rule.comparative.irregular", "rule.than", "rule.preposition", "rule.passive.be",
          "rule.passive.of", "rule.passive.from", "rule.adjective.degree", "rule.article.adjective",
          "rule.article.material", "rule.noun.material", "rule.this", "rule.contraction"}) {
        needs.push_back({key, words});
    }
    return needs;
}

}  // namespace

std::string rule_key(const FormError& error) {
    if (error.passive) {
        return passive_rule(error);
    }
    if (error.role == Role::adjective) {
        return error.degree == Degree::positive ? positive_rule(error) : degree_rule(error);
    }
    if (is_of_pointing(error)) {
        return "rule.this";
    }
    if (is_of_contraction(error)) {
        return "rule.contraction";
    }
    if (is_of_material(error)) {
        return error.role == Role::noun ? "rule.noun.material" : "rule.article.material";
    }
    if (error.code == ErrorCode::extra_determiner && error.target &&
        error.degree == Degree::positive) {
        return "rule.article.adjective";
    }
    if (error.role == Role::determiner && error.target &&
        error.code != ErrorCode::extra_determiner) {
        return "rule.superlative.the";
    }
    if (error.code == ErrorCode::wrong_preposition ||
        error.code == ErrorCode::missing_preposition) {
        return error.right == "than" ? "rule.than" : "rule.preposition";
    }
    for (const auto& [code, key] : kRules) {
        if (code == error.code) {
            return std::string(key);
        }
    }
    return "rule.spelling";
}

std::span<const CatalogueNeed> conversation_needs() {
    static const std::vector<CatalogueNeed> needs = make_needs();
    return needs;
}

}  // namespace fulcrum::dialogue
