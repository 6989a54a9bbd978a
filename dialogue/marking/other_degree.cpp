#include "dialogue/marking/other_degree.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/resolve_articles.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace fulcrum::dialogue {
namespace {

bool is_form(const std::string& said, std::string_view base, Degree degree) {
    const std::vector<std::string> forms = degree_forms(base, degree);
    return std::ranges::find(forms, lower_case(said)) != forms.end();
}

/// It fills a slot from a list of three or more, between two of which the question does not ask.
bool is_one_of_many(const Question& question, const Piece& piece) {
    if (piece.element.slot == kNone || piece.element.role != Role::noun) {
        return false;
    }
    const TemplateSet& set = *question.templates;
    const auto slot = static_cast<std::size_t>(piece.element.slot);
    const WordList& list = set.lists[static_cast<std::size_t>(set.slot_lists[slot])];
    constexpr std::size_t kMany = 3;
    return list.items.size() >= kMany && asked_between(question, list).empty();
}

/// "Heavy", "heaviest": a right form of the adjective, behind which nothing shows that another one was meant.
bool is_right_elsewhere(const FormError& error, std::string_view said) {
    constexpr std::string_view kComparing[] = {"than", "then", "as", "that"};
    const bool is_right = error.code == ErrorCode::adjective_form &&
                          error.role == Role::adjective &&
                          (is_form(error.said, error.base, Degree::positive) ||
                           is_form(error.said, error.base, Degree::comparative) ||
                           is_form(error.said, error.base, Degree::superlative));
    const std::vector<std::string> behind = words_of(said.substr(std::min(error.end, said.size())));
    return is_right && std::ranges::none_of(behind, [&](const std::string& word) {
               return std::ranges::find(kComparing, word) != std::end(kComparing);
           });
}

/// "Roughest" where the template has "rougher", and no "than" behind it.
bool is_superlative_for_comparative(const std::vector<Piece>& pieces, int at) {
    const Piece& adjective = pieces[static_cast<std::size_t>(at)];
    const int next = after(pieces, at);
    return adjective.element.role == Role::adjective && adjective.element.slot == kNone &&
           adjective.element.degree == Degree::comparative &&
           adjective.code == ErrorCode::adjective_form &&
           is_form(adjective.said, adjective.element.base, Degree::superlative) &&
           (next == kNone || pieces[static_cast<std::size_t>(next)].right != "than");
}

/// "The", where it is what was said last before `at`.
Piece* find_the_before(std::vector<Piece>& pieces, int at) {
    for (int i = at - 1; i >= 0; --i) {
        Piece& before = pieces[static_cast<std::size_t>(i)];
        if (!before.said.empty()) {
            return lower_case(before.said) == "the" ? &before : nullptr;
        }
    }
    return nullptr;
}

void let_pass(std::string right, Piece& piece) {
    piece.right = std::move(right);
    piece.code = ErrorCode::none;
    piece.cost = 0;
}

}  // namespace

void allow_superlative(const Question& question, std::vector<Piece>& pieces) {
    const auto is_many = [&](const Piece& piece) { return is_one_of_many(question, piece); };
    if (std::ranges::none_of(pieces, is_many)) {
        return;
    }
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        if (!is_superlative_for_comparative(pieces, i)) {
            continue;
        }
        Piece* the = find_the_before(pieces, i);
        // Things have it, "the roughest"; at one place a thing is "easiest".
        const int next = after(pieces, i);
        const bool of_place =
            next != kNone &&
            pieces[static_cast<std::size_t>(next)].element.role != Role::adjective &&
            std::none_of(pieces.begin(), pieces.begin() + i, is_many);
        if (the == nullptr && !of_place) {
            continue;
        }
        if (the != nullptr) {
            let_pass("the", *the);
        }
        Piece& adjective = pieces[static_cast<std::size_t>(i)];
        let_pass(lower_case(adjective.said), adjective);
    }
}

bool says_other_degree(const Mark& mark) {
    return std::ranges::any_of(mark.form_errors, [&](const FormError& error) {
        return is_right_elsewhere(error, mark.said);
    });
}

void excuse_other_degree(Mark& mark) {
    std::vector<std::size_t> excused;  // where each begins
    for (const FormError& error : mark.form_errors) {
        if (is_right_elsewhere(error, mark.said)) {
            excused.push_back(error.begin);
        }
    }
    // The article of the form that was not meant goes with it: "the egg is heavier" for "the heaviest".
    std::erase_if(mark.form_errors, [&](const FormError& error) {
        return std::ranges::find(excused, error.begin) != excused.end() &&
               (error.code == ErrorCode::adjective_form ||
                error.code == ErrorCode::missing_determiner);
    });
}

}  // namespace fulcrum::dialogue
