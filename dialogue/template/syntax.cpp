#include "dialogue/template/syntax.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/tokens.h"
#include "dialogue/unicode.h"

#include <algorithm>

namespace fulcrum::dialogue {
namespace {

using Kind = SyntaxNode::Kind;

bool is_name_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_name(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), is_name_character);
}

/// Recursive descent; kDeepestTemplate bounds the stack. NOLINTBEGIN(misc-no-recursion)
class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    Expected<Syntax> run() {
        if (text_.size() > kLongestTemplate_bytes) {
            return fail(
                concat({"the template is longer than ", std::to_string(kLongestTemplate_bytes),
                        " bytes; part it into rules or several answers"}));
        }
        const auto root = group('\0', 0);
        if (!root) {
            return tl::unexpected(root.error());
        }
        return std::move(nodes_);
    }

  private:
    [[nodiscard]] int column() const { return static_cast<int>(at_) + 1; }
    [[nodiscard]] bool done() const { return at_ >= text_.size(); }

    int add(Kind kind, int column) {
        nodes_.push_back({kind, {}, {}, {}, column});
        return static_cast<int>(nodes_.size()) - 1;
    }
    SyntaxNode& node(int index) { return nodes_[static_cast<std::size_t>(index)]; }

    /// The inside of a bracket up to `closing` (or the whole text for '\0'): sequences parted by | or ;.
    Expected<int> group(char closing, int depth) {
        if (depth > kDeepestTemplate) {
            return fail(concat({"brackets are nested deeper than ",
                                std::to_string(kDeepestTemplate), "; use a <rule>"}),
                        column());
        }
        const int opened = column() - (closing == '\0' ? 0 : 1);
        const int holder = add(Kind::alternatives, opened);
        char parting = '\0';
        while (true) {
            const auto part = sequence(depth);
            if (!part) {
                return part;
            }
            node(holder).children.push_back(*part);
            if (done() || text_[at_] == closing) {
                break;
            }
            const char sign = text_[at_];
            if (sign != '|' && sign != ';') {
                return fail(
                    concat({"'", {&sign, 1}, "' closes nothing; take it out, or open it before"}),
                    column());
            }
            if (parting != '\0' && sign != parting) {
                return fail("'|' and ';' are mixed in one bracket; use a bracket for each",
                            column());
            }
            parting = sign;
            ++at_;
        }
        if (done() && closing != '\0') {
            return fail(
                concat({"the bracket opened here is never closed; add '", {&closing, 1}, "'"}),
                opened);
        }
        at_ += closing == '\0' ? 0 : 1;
        return finish_group(holder, parting);
    }

    Expected<int> finish_group(int holder, char parting) {
        SyntaxNode& whole = node(holder);
        if (parting == ';') {
            whole.kind = Kind::permutation;
            if (whole.children.size() > kLargestPermutation) {
                return fail(concat({"more than ", std::to_string(kLargestPermutation),
                                    " parts in any order; write the orders out"}),
                            whole.column);
            }
        }
        return holder;
    }

    /// Parts one after another, up to a sign that ends them.
    Expected<int> sequence(int depth) {
        const int holder = add(Kind::sequence, column());
        while (!done() && std::string_view("|;)]}>").find(text_[at_]) == std::string_view::npos) {
            const auto next = part(holder, depth);
            if (!next) {
                return tl::unexpected(next.error());
            }
        }
        return holder;
    }

    Expected<bool> part(int holder, int depth) {
        const char sign = text_[at_];
        if (sign == '[' || sign == '(') {
            return bracket(holder, sign, depth);
        }
        if (sign == '{' || sign == '<') {
            return reference(holder, sign);
        }
        return words(holder);
    }

    Expected<bool> bracket(int holder, char sign, int depth) {
        const int start = column();
        if (touches_word()) {
            return fail("a space is missing before the bracket; brackets hold whole words", start);
        }
        const int outer = sign == '[' ? add(Kind::optional, start) : -1;
        ++at_;
        const auto inner = group(sign == '[' ? ']' : ')', depth + 1);
        if (!inner) {
            return tl::unexpected(inner.error());
        }
        if (outer >= 0) {
            node(outer).children.push_back(*inner);
        }
        node(holder).children.push_back(outer >= 0 ? outer : *inner);
        if (!done() && is_name_character(text_[at_])) {
            return fail("a space is missing after the bracket; brackets hold whole words",
                        column());
        }
        return true;
    }

    [[nodiscard]] bool touches_word() const { return at_ > 0 && is_name_character(text_[at_ - 1]); }

    /// {list}, {list:slot}, <rule>, <form:word> or <form:{list}>.
    Expected<bool> reference(int holder, char sign) {
        const int start = column();
        const char closing = sign == '{' ? '}' : '>';
        const std::size_t end = text_.find(closing, at_);
        if (end == std::string_view::npos) {
            return fail(concat({"the '",
                                {&sign, 1},
                                "' opened here is never closed; add '",
                                {&closing, 1},
                                "'"}),
                        start);
        }
        const std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
        const std::size_t colon = std::min(inside.find(':'), inside.size());
        const std::string_view name = without_blanks(inside.substr(0, colon));
        const std::string_view argument =
            without_blanks(inside.substr(std::min(colon + 1, inside.size())));
        if (!is_name(name)) {
            return no_name(sign, closing, without_blanks(inside), start + 1);
        }
        if (sign == '<' && argument.substr(0, 1) == "{") {
            return form_of_list(holder, name, end);
        }
        if (colon < inside.size() &&
            (argument.empty() || (sign == '{' && !is_name(argument)) ||
             argument.find_first_of("[](){}<>|;") != std::string_view::npos)) {
            return fail("a word is missing after ':'", start + 2 + static_cast<int>(colon));
        }
        const int made = add(sign == '{' ? Kind::list : Kind::rule, start);
        node(made).text = std::string(name);
        node(made).argument = std::string(argument);
        node(holder).children.push_back(made);
        at_ = end + 1;
        return true;
    }

    /// What stands between < and > or { and } without being a name: mostly a blank where a colon belongs.
    static tl::unexpected<Error> no_name(char sign, char closing, std::string_view inside,
                                         int column) {
        const std::string_view open(&sign, 1);
        const std::string_view close(&closing, 1);
        const std::string said = concat({open, inside, close});
        if (inside.empty()) {
            return fail(
                said + (sign == '<' ? " is empty; write a form of grammar with its word, such as "
                                      "<superlative:heavy>, or the name of a rule"
                                    : " is empty; write the name of a list, such as {thing}"),
                column);
        }
        const std::size_t blank = inside.find(' ');
        const std::string_view first = inside.substr(0, blank);
        const std::string_view rest = blank == std::string_view::npos
                                          ? std::string_view()
                                          : without_blanks(inside.substr(blank));
        if (is_name(first) && (is_name(rest) || rest.starts_with('{'))) {
            return fail(concat({said, " has a space where a colon belongs; write ", open, first,
                                ":", rest, close}),
                        column);
        }
        return fail(
            said + (sign == '<' ? " is no form of grammar and no rule: a name has letters, digits "
                                  "and _, and its word stands behind a colon, as in "
                                  "<superlative:heavy>"
                                : " is no list: a name has letters, digits and _, as in {thing} or "
                                  "{thing:other}"),
            column);
    }

    /// <form:{list}> or <form:{list:slot}> from `at_` to `end`; the list becomes the form's child.
    Expected<bool> form_of_list(int holder, std::string_view name, std::size_t end) {
        const int made = add(Kind::rule, column());
        node(made).text = std::string(name);
        at_ = text_.find('{', at_);
        const auto list = reference(made, '{');
        if (!list) {
            return list;
        }
        if (at_ > end || !without_blanks(text_.substr(at_, end - at_)).empty()) {
            return fail("only one {list} may stand in < >; close it with '>'", column());
        }
        node(holder).children.push_back(made);
        at_ = end + 1;
        return true;
    }

    /// Plain words up to the next sign; a backslash takes the meaning from a sign.
    Expected<bool> words(int holder) {
        const std::size_t start = at_;
        std::string plain;
        while (!done() &&
               std::string_view("[](){}<>|;").find(text_[at_]) == std::string_view::npos) {
            if (text_[at_] == '\\') {
                plain.push_back(' ');  // keeps the columns of the words right
                ++at_;
                if (done()) {
                    return fail("'\\' stands at the end; a character must follow", column() - 1);
                }
            }
            plain.push_back(text_[at_]);
            ++at_;
        }
        for (const Token& token : tokenise(plain)) {
            const int made = add(Kind::word, static_cast<int>(start + token.begin) + 1);
            node(made).text = token.text;
            node(made).argument = written(plain, token, start + token.begin == 0);
            node(holder).children.push_back(made);
        }
        return true;
    }

    /// How a word is shown where that differs from its text: "Earth", "twenty-" of "twenty-four". At the start of a
    /// template a capital says nothing.
    static std::string written(std::string_view plain, const Token& token, bool starts) {
        std::string letters(plain.substr(token.begin, token.end - token.begin));
        if (token.text == "not" && lower_case(letters) != "not") {
            return "n't";  // "isn't it?" is not asked as "is not it?"
        }
        if (folded(letters) != token.text) {
            return {};  // part of a contraction, a number in digits
        }
        if (token.end + 1 < plain.size() && plain[token.end] == '-' &&
            is_name_character(plain[token.end + 1])) {
            letters.push_back('-');
        }
        const bool first_capital =
            starts && lower_case(letters).substr(1) == std::string_view(letters).substr(1);
        letters = first_capital ? lower_case(letters) : letters;
        return letters == token.text ? std::string() : letters;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    Syntax nodes_;
};
// NOLINTEND(misc-no-recursion)

}  // namespace

Expected<Syntax> parse_template(std::string_view text) {
    return Parser(text).run();
}

}  // namespace fulcrum::dialogue
