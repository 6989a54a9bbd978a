#include "dialogue/template/what_follows.h"

#include "dialogue/english/determiner.h"
#include "dialogue/english/verb.h"
#include "dialogue/template/phrases.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace fulcrum::dialogue {
namespace {

using Kind = SyntaxNode::Kind;

/// The first word of a part where it begins with one, whatever comes behind it; "" where it doesn't.
std::string_view first_word(const Syntax& syntax, const SyntaxNode& part) {
    const SyntaxNode* first = &part;
    while (first->kind != Kind::word) {
        if (first->children.empty() || first->kind == Kind::rule || first->kind == Kind::list) {
            return {};
        }
        first = &part_at(syntax, first->children[0]);
    }
    return first->text;
}

}  // namespace

const SyntaxNode& unwrapped(const Syntax& syntax, int index) {
    const SyntaxNode* part = &part_at(syntax, index);
    while ((part->kind == Kind::sequence || part->kind == Kind::alternatives) &&
           part->children.size() == 1) {
        part = &part_at(syntax, part->children[0]);
    }
    return *part;
}

bool may_be_noun(const SyntaxNode& part) {
    VerbForms forms;
    return part.kind == Kind::word && !is_article(part.text) && !is_demonstrative(part.text) &&
           !is_preposition(part.text) && !understand_verb(part.text, forms);
}

bool is_head_noun(const SyntaxNode& part, const SyntaxNode* next) {
    return may_be_noun(part) && part.argument.empty() && (next == nullptr || !may_be_noun(*next)) &&
           (next == nullptr || next->kind != Kind::list);
}

bool is_determined(const Syntax& syntax, int index) {
    const SyntaxNode& part = unwrapped(syntax, index);
    if (part.kind == Kind::alternatives) {
        return std::all_of(part.children.begin(), part.children.end(), [&](int child) {
            const SyntaxNode& inner = unwrapped(syntax, child);
            return inner.kind == Kind::word && is_sole_determiner(inner.text);
        });
    }
    return part.kind == Kind::word && part.text != "that" &&
           (is_sole_determiner(part.text) || part.text == "one");
}

// By recursion; kDeepestTemplate bounds the stack.
// NOLINTBEGIN(misc-no-recursion)
bool takes_no_article(const Syntax& syntax, int index) {
    constexpr std::array<std::string_view, 8> kAmounts = {"no",   "any",  "some", "enough",
                                                          "more", "much", "less", "little"};
    const SyntaxNode& part = unwrapped(syntax, index);
    if (part.kind == Kind::alternatives) {
        return std::all_of(part.children.begin(), part.children.end(),
                           [&](int child) { return takes_no_article(syntax, child); });
    }
    if (part.kind == Kind::sequence) {
        return !part.children.empty() && takes_no_article(syntax, part.children.back());
    }
    return part.kind == Kind::word &&
           std::find(kAmounts.begin(), kAmounts.end(), part.text) != kAmounts.end();
}
// NOLINTEND(misc-no-recursion)

bool is_optional_noun(const Syntax& syntax, const SyntaxNode* part) {
    if (part == nullptr || part->kind != Kind::optional) {
        return false;
    }
    const SyntaxNode& inside = unwrapped(syntax, part->children[0]);
    if (inside.kind != Kind::alternatives) {
        return may_be_noun(inside);
    }
    return std::all_of(inside.children.begin(), inside.children.end(),
                       [&](int child) { return may_be_noun(unwrapped(syntax, child)); });
}

bool closes_phrase(const Syntax& syntax, const SyntaxNode* next, bool beyond) {
    if (next == nullptr) {
        return beyond;
    }
    const std::string_view word = first_word(syntax, *next);
    VerbForms forms;
    return understand_verb(word, forms) || (is_preposition(word) && word != "of");
}

bool begins_with_than(const Syntax& syntax, const SyntaxNode* part) {
    return part != nullptr && first_word(syntax, *part) == "than";
}

}  // namespace fulcrum::dialogue
