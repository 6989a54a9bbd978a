#include "dialogue/template/sentence_parts.h"

#include "dialogue/english/letters.h"
#include "dialogue/result.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {

using NodeKind = SyntaxNode::Kind;

/// "{yes}", "{neither}": a list that says itself whether it is so.
bool says_yes_or_no(const WordList& list) {
    constexpr std::array<std::string_view, 7> kWords = {"yes",  "no",      "none", "neither",
                                                        "both", "nothing", "not"};
    return std::ranges::all_of(list.items, [&](const ListItem& item) {
        const std::string text = lower_case(item.value);
        return std::ranges::find(kWords, text.substr(0, text.find(' '))) != kWords.end();
    });
}

/// One side of a place within its bracket.
struct Side {
    std::size_t edge = 0;                     ///< where the way ends on which that place is
    std::size_t bracket = std::string::npos;  ///< that it is in; none around the whole
};

Side side_of(const std::string& text, std::size_t at, bool leftwards) {
    const std::string_view inner = leftwards ? ")]" : "([";
    const std::string_view outer = leftwards ? "([" : ")]";
    Side side{.edge = at};
    int depth = 0;
    bool barred = false;
    for (std::size_t n = leftwards ? at : text.size() - at; n-- > 0;) {
        const std::size_t i = leftwards ? n : text.size() - 1 - n;
        const bool closes = outer.find(text[i]) != std::string_view::npos;
        if (closes && depth == 0) {
            side.bracket = i;
            break;
        }
        const bool opens = inner.find(text[i]) != std::string_view::npos;
        depth += static_cast<int>(opens) - static_cast<int>(closes);
        barred = barred || (depth == 0 && text[i] == '|');
        if (!barred) {
            side.edge = leftwards ? i : i + 1;
        }
    }
    return side;
}

}  // namespace

SentenceParts::SentenceParts(const TemplateSet& set, const ParsedRules& rules,
                             const std::string& text, const Syntax& syntax)
    : set_(set), rules_(rules), text_(text), syntax_(syntax) {
    const SyntaxNode& whole = syntax_[0];
    if (whole.kind == NodeKind::alternatives && whole.children.size() == 1) {
        parts_ = part_at(syntax_, whole.children[0]).children;
    }
}

const SyntaxNode& SentenceParts::part(std::size_t i) const {
    return unwrapped(syntax_, parts_[i]);
}

std::size_t SentenceParts::column(std::size_t i) const {
    return i < parts_.size() ? static_cast<std::size_t>(part_at(syntax_, parts_[i]).column) - 1
                             : text_.size();
}

std::string SentenceParts::text(std::size_t first, std::size_t last) const {
    const std::size_t begin = column(first);
    return std::string(without_blanks(
        first < last ? std::string_view(text_).substr(begin, column(last) - begin) : ""));
}

bool SentenceParts::is_word(std::size_t i, std::string_view word) const {
    return i < size() && part(i).kind == NodeKind::word && part(i).text == word;
}

bool SentenceParts::is_be(std::size_t i) const {
    return is_word(i, "is") || is_word(i, "are") || be_of(part(i)) != nullptr;
}

const SyntaxNode* SentenceParts::be_of(const SyntaxNode& node) const {
    if (node.kind != NodeKind::alternatives) {
        return nullptr;
    }
    for (const int child : node.children) {
        const SyntaxNode& inner = unwrapped(syntax_, child);
        if (inner.kind == NodeKind::word && (inner.text == "is" || inner.text == "are")) {
            return &inner;
        }
    }
    return nullptr;
}

std::string SentenceParts::be(std::size_t i) const {
    const SyntaxNode* of = be_of(part(i));
    return of != nullptr ? of->text : part(i).text;
}

std::string_view SentenceParts::form(std::size_t i) const {
    const bool is_form =
        i < size() && part(i).kind == NodeKind::rule && !rules_.contains(part(i).text);
    return is_form ? std::string_view(part(i).text) : std::string_view();
}

bool SentenceParts::begins_with(std::size_t i, std::string_view word) const {
    const SyntaxNode* node = &part(i);
    while (node->kind != NodeKind::word && !node->children.empty()) {
        node = &unwrapped(syntax_, node->children[0]);
    }
    return node->kind == NodeKind::word && node->text == word;
}

std::vector<std::string> SentenceParts::adjectives(std::size_t i, std::string_view degree) const {
    if (i >= size()) {
        return {};
    }
    std::vector<const SyntaxNode*> nodes{&part(i)};
    if (part(i).kind == NodeKind::alternatives) {
        nodes.clear();
        for (const int child : part(i).children) {
            nodes.push_back(&unwrapped(syntax_, child));
        }
    }
    std::vector<std::string> words;
    for (const SyntaxNode* node : nodes) {
        if (node->kind != NodeKind::rule || node->text != degree || !node->children.empty()) {
            return {};
        }
        words.push_back(node->argument);
    }
    return words;
}

std::vector<std::string> SentenceParts::slots(std::size_t first, std::size_t last) const {
    std::vector<std::string> found;
    for (std::size_t i = first; i < last && i < size(); ++i) {
        std::vector<int> rest{parts_[i]};
        while (!rest.empty()) {
            const SyntaxNode& node = part_at(syntax_, rest.back());
            rest.pop_back();
            if (node.kind == NodeKind::list) {
                found.push_back(node.argument.empty() ? node.text : node.argument);
            } else if (node.kind == NodeKind::rule && rules_.contains(node.text)) {
                found.emplace_back();
            }
            rest.insert(rest.end(), node.children.begin(), node.children.end());
        }
    }
    return found;
}

std::size_t SentenceParts::than_at(std::size_t first) const {
    std::size_t i = first;
    while (i < size() && !begins_with_than(syntax_, &part(i))) {
        ++i;
    }
    return i;
}

const WordList* SentenceParts::list_of(const std::string& slot) const {
    const auto found = std::ranges::find(set_.slots, slot);
    if (found == set_.slots.end()) {
        return nullptr;
    }
    const auto at = static_cast<std::size_t>(found - set_.slots.begin());
    return &set_.lists[static_cast<std::size_t>(set_.slot_lists[at])];
}

bool SentenceParts::same_words(const std::string& one, const std::string& other) const {
    const WordList* a = list_of(one);
    const WordList* b = list_of(other);
    return a != nullptr && b != nullptr && a->items.size() == b->items.size() &&
           std::ranges::all_of(a->items, [&](const ListItem& item) {
               return std::ranges::find(b->items, item.value, &ListItem::value) != b->items.end();
           });
}

std::string SentenceParts::head_of(const std::string& slot) const {
    const WordList* list = list_of(slot);
    std::string head;
    for (const ListItem& item : list == nullptr ? std::vector<ListItem>{} : list->items) {
        const std::string& text = item.spoken.front().text;
        const std::size_t blank = text.rfind(' ');
        const std::string last = blank == std::string::npos ? "" : text.substr(blank + 1);
        if (last.empty() || (!head.empty() && last != head)) {
            return {};
        }
        head = last;
    }
    return head;
}

bool SentenceParts::is_plain_statement() const {
    constexpr std::array<std::string_view, 14> kNoStatement = {
        "how",  "what", "which", "where", "who", "whose", "why",
        "when", "is",   "are",   "does",  "can", "do",    "there"};
    if (parts_.empty() || text_.find('\\') != std::string::npos ||
        std::ranges::find(kNoStatement, part(0).text) != kNoStatement.end()) {
        return false;
    }
    const bool says_not = std::ranges::any_of(syntax_, [](const SyntaxNode& node) {
        return node.kind == NodeKind::word && (node.text == "not" || node.text == "no");
    });
    return !says_not && std::ranges::none_of(slots(0, size()), [&](const std::string& slot) {
        const WordList* list = list_of(slot);
        return list != nullptr && says_yes_or_no(*list);
    });
}

std::string SentenceParts::denied(std::size_t at) const {
    std::size_t begin = at;
    std::size_t end = std::min(text_.find_first_of(" |])", at), text_.size());
    std::string inner = text_.substr(begin, end - begin) + " not";
    while (true) {
        const Side left = side_of(text_, begin, true);
        const Side right = side_of(text_, end, false);
        inner = concat({text_.substr(left.edge, begin - left.edge), inner,
                        text_.substr(end, right.edge - end)});
        if (left.bracket == std::string::npos) {
            return inner;
        }
        begin = left.bracket;
        end = right.bracket + 1;
    }
}

}  // namespace fulcrum::dialogue
