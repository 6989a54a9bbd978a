// Walks the tree of a template by recursion; kDeepestTemplate and kDeepestRules bound the stack.
// NOLINTBEGIN(misc-no-recursion)
#include "dialogue/template/graph_builder.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/number.h"
#include "dialogue/template/what_follows.h"

#include <algorithm>
#include <optional>

namespace fulcrum::dialogue {
namespace {

using Kind = SyntaxNode::Kind;
constexpr std::size_t kDeepestRules = 24;

/// The article that a part asks for when it consists of articles only: "the", "[the|a|an]", "(a|an)", <article>. The one
/// that stands first is the author's own; the others are only let pass.
std::optional<ArticlePolicy> article_policy(const Syntax& syntax, int index) {
    const SyntaxNode& part = unwrapped(syntax, index);
    if (part.kind == Kind::word && is_article(part.text)) {
        return part.text == "the" ? ArticlePolicy::definite : ArticlePolicy::indefinite;
    }
    if (part.kind == Kind::rule && part.text == "article") {
        return ArticlePolicy::indefinite;
    }
    if (part.kind == Kind::optional) {
        return article_policy(syntax, part.children[0]);
    }
    if (part.kind != Kind::alternatives) {
        return std::nullopt;
    }
    std::optional<ArticlePolicy> first;
    for (const int child : part.children) {
        const auto inner = article_policy(syntax, child);
        if (!inner) {
            return std::nullopt;
        }
        first = first ? first : inner;
    }
    return first;
}

/// What to write instead of a list's `name` that isn't there: the one that it is a slip of, or which there are.
std::string known_lists(const std::vector<WordList>& lists, std::string_view name) {
    std::string names;
    std::string nearest;
    int least =
        std::min(3, static_cast<int>(name.size() + 1) / 2);  // a slip is less than half of the name
    for (const WordList& list : lists) {
        names += (names.empty() ? "" : ", ") + list.name;
        if (const int distance = edit_distance(list.name, name); distance < least) {
            least = distance;
            nearest = list.name;
        }
    }
    if (!nearest.empty()) {
        return "did you mean " + nearest + "?";
    }
    return "the lists are: " + (names.empty() ? "none" : names);
}

bool is_adjective(const SyntaxNode& part) {
    return part.kind == Kind::rule &&
           (part.text == "adjective" || part.text == "comparative" || part.text == "superlative");
}

/// What is behind the `i`th part of a sequence; null behind the last.
const SyntaxNode* part_behind(const Syntax& syntax, const SyntaxNode& whole, std::size_t i) {
    return i + 1 < whole.children.size() ? &unwrapped(syntax, whole.children[i + 1]) : nullptr;
}

/// An article of plain words, and the node before it.
struct SaidArticle {
    std::optional<ArticlePolicy> policy{};
    int from = kNone;
};

/// "Apples" beside "an apple", where `part`, which ends at `to`, is its noun.
void add_kind_behind(ArcWriter& writer, const SaidArticle& article, const SyntaxNode& part,
                     const SyntaxNode* next, int to) {
    if (article.policy && is_head_noun(part, next)) {
        const bool definite = *article.policy == ArticlePolicy::definite;
        add_kind(writer, definite ? "the" : "a", part.text, article.from, to);
    }
}

/// The number of a subject that is a plain word.
SubjectNumber subject_number(const SyntaxNode& part) {
    if (part.kind != Kind::word) {
        return SubjectNumber::unknown;
    }
    for (const std::string_view plural : {"they", "these", "those", "both"}) {
        if (part.text == plural) {
            return SubjectNumber::plural;
        }
    }
    if (is_number_word(part.text)) {
        return part.text == "one" ? SubjectNumber::singular : SubjectNumber::plural;
    }
    return looks_plural(part.text) ? SubjectNumber::plural : SubjectNumber::singular;
}

/// What stands before the part behind `done`; in a noun phrase that is the list, and its article went before.
Neighbours behind(const SyntaxNode& done, bool has_article, bool noun_phrase) {
    Neighbours neighbours;
    neighbours.after_article = has_article && !noun_phrase;
    neighbours.after_list = noun_phrase || done.kind == Kind::list;
    neighbours.after_adjective = is_adjective(done);
    neighbours.after_it = done.kind == Kind::rule && done.text == "it";
    neighbours.subject = subject_number(done);
    neighbours.behind_is = done.kind == Kind::word && done.text == "is";
    neighbours.begins_phrase = done.kind == Kind::word && is_preposition(done.text);
    return neighbours;
}

/// What may stand between a determiner and its noun: a form of an adjective, "long", {colour}, or one of them in brackets.
bool is_attribute(const TemplateSet& set, const Syntax& syntax, int index) {
    const SyntaxNode& part = unwrapped(syntax, index);
    if (part.kind == Kind::optional || part.kind == Kind::alternatives) {
        return std::all_of(part.children.begin(), part.children.end(),
                           [&](int child) { return is_attribute(set, syntax, child); });
    }
    if (part.kind == Kind::list) {
        return std::any_of(set.lists.begin(), set.lists.end(), [&](const WordList& list) {
            return list.name == part.text && all_describe(list);
        });
    }
    return is_adjective(part) || (part.kind == Kind::word && describes(part.text));
}

/// The number of the plain noun that follows the part `at_part` of a sequence: "the big *egg* is"; `beyond` behind its end.
SubjectNumber noun_number_after(const Syntax& syntax, const SyntaxNode& sequence,
                                std::size_t at_part, SubjectNumber beyond) {
    if (at_part + 1 == sequence.children.size()) {
        return beyond;
    }
    SubjectNumber number = SubjectNumber::unknown;
    for (std::size_t i = at_part + 1; i < sequence.children.size(); ++i) {
        const SyntaxNode& next = unwrapped(syntax, sequence.children[i]);
        if (!may_be_noun(next)) {
            break;
        }
        number = next.argument.empty() ? subject_number(next) : SubjectNumber::name;
    }
    return number;
}

}  // namespace

Expected<Built> GraphBuilder::build(const Syntax& syntax, int from) {
    return node(syntax, 0, from, {.closes = true});
}

Expected<bool> GraphBuilder::step(const SyntaxNode& part) {
    if (writer_.full()) {
        return fail(concat({"the templates grow beyond ", std::to_string(kLargestGraph_arcs),
                            " arcs here; use fewer rules within rules, or shorter lists"}),
                    part.column);
    }
    return true;
}

Expected<Built> GraphBuilder::node(const Syntax& syntax, int index, int from,
                                   Neighbours neighbours) {
    const SyntaxNode& part = part_at(syntax, index);
    if (const auto within = step(part); !within) {
        return tl::unexpected(within.error());
    }
    switch (part.kind) {
        case Kind::sequence:
            return sequence(syntax, part, from, neighbours);
        case Kind::alternatives:
            return alternatives(syntax, part, false, from, neighbours);
        case Kind::optional:
            return alternatives(syntax, part, true, from, neighbours);
        case Kind::permutation:
            return permutation(syntax, part, from);
        case Kind::list:
            return list(part,
                        neighbours.after_no    ? ArticlePolicy::after_no
                        : neighbours.in_phrase ? ArticlePolicy::determined
                                               : ArticlePolicy::bare,
                        from, neighbours.behind_is);
        case Kind::rule:
            return rule(syntax, part, from, neighbours);
        case Kind::word:
            break;
    }
    Built built{writer_.add_node()};
    const std::string& shown = part.argument.empty() ? part.text : part.argument;
    add_word(writer_, part.text, shown, neighbours, from, built.to);
    return built;
}

Expected<Built> GraphBuilder::sequence(const Syntax& syntax, const SyntaxNode& part, int from,
                                       Neighbours neighbours) {
    Built built{from};
    const bool adjective_follows = neighbours.before_adjective;
    const bool closes = neighbours.closes;
    const SubjectNumber noun_follows = neighbours.noun;
    SaidArticle article;
    for (std::size_t i = 0; i < part.children.size(); ++i) {
        const int child = part.children[i];
        const auto policy = article_policy(syntax, child);
        const std::size_t first = i;
        const SyntaxNode* next = part_behind(syntax, part, i);
        neighbours.before_adjective = next != nullptr ? is_adjective(*next) : adjective_follows;
        neighbours.closes = closes_phrase(syntax, next, closes);
        neighbours.before_than = begins_with_than(syntax, next);
        neighbours.noun =
            policy ? noun_number_after(syntax, part, i, noun_follows) : SubjectNumber::unknown;
        const bool noun_phrase = policy && next != nullptr && next->kind == Kind::list;
        const int start = built.to;
        const auto made = noun_phrase ? list(*next, *policy, built.to, neighbours.behind_is)
                                      : node(syntax, child, built.to, neighbours);
        if (!made) {
            return made;
        }
        i += noun_phrase ? 1 : 0;
        if ((built.slots & made->slots) != 0) {
            return fail(
                "a slot is filled twice in one sentence; give one of them a name of its own, as "
                "{thing:other}",
                part_at(syntax, part.children[i]).column);
        }
        built = {made->to, built.slots | made->slots, built.required | made->required,
                 built.definite | made->definite};
        built.to = add_tail(syntax, part, first, i, closes, built.to);
        const SyntaxNode& done = unwrapped(syntax, child);
        const bool in_phrase =
            noun_phrase ? is_attribute(set_, syntax, part.children[i])
                        : is_determined(syntax, child) ||
                              (neighbours.in_phrase && is_attribute(set_, syntax, child));
        add_kind_behind(writer_, article, done, next, built.to);
        article = noun_phrase ? SaidArticle{} : SaidArticle{policy, start};
        neighbours = behind(done, policy.has_value(), noun_phrase);
        neighbours.in_phrase = in_phrase;
        neighbours.after_no = takes_no_article(syntax, child);
    }
    return built;
}

int GraphBuilder::add_tail(const Syntax& syntax, const SyntaxNode& sequence, std::size_t first,
                           std::size_t last, bool closes, int from) {
    const auto part = [&](std::size_t i) { return &unwrapped(syntax, sequence.children[i]); };
    const SyntaxNode* before = first > 0 ? part(first - 1) : nullptr;
    const SyntaxNode* next = part_behind(syntax, sequence, last);
    if (before == nullptr || !closes_phrase(syntax, next, closes)) {
        return from;
    }
    if (before->kind == Kind::rule && before->text == "superlative" &&
        is_optional_noun(syntax, part(last))) {
        return add_of_all(writer_, OneToo::no, from);
    }
    const bool compared = before->kind == Kind::word && before->text == "than";
    const bool ends = part(last)->kind == Kind::list && next == nullptr;
    return compared && ends ? add_than_is(writer_, from) : from;
}

Expected<Built> GraphBuilder::alternatives(const Syntax& syntax, const SyntaxNode& part,
                                           bool optional, int from, Neighbours neighbours) {
    Built built{writer_.add_node()};
    bool first = true;
    if (optional) {
        writer_.join(from, built.to);
        first = false;
    }
    for (const int child : part.children) {
        const auto made = node(syntax, child, from, neighbours);
        if (!made) {
            return made;
        }
        writer_.join(made->to, built.to);
        built.slots |= made->slots;
        built.definite |= made->definite;
        built.required = first ? made->required : (built.required & made->required);
        first = false;
    }
    return built;
}

Expected<Built> GraphBuilder::permutation(const Syntax& syntax, const SyntaxNode& part, int from) {
    // A node for each set of parts already said; a part leads from each set without it to the set with it.
    const std::size_t count = part.children.size();
    const std::size_t sets = std::size_t{1} << count;
    std::vector<int> nodes(sets);
    for (std::size_t set = 0; set < sets; ++set) {
        nodes[set] = set == 0 ? from : writer_.add_node();
    }
    Built built{nodes.back()};
    for (std::size_t set = 0; set < sets; ++set) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t bit = std::size_t{1} << i;
            if ((set & bit) != 0) {
                continue;
            }
            const auto made = node(syntax, part.children[i], nodes[set], {});
            if (!made) {
                return made;
            }
            writer_.join(made->to, nodes[set | bit]);
            built.slots |= made->slots;
            built.required |= made->required;
            built.definite |= made->definite;
        }
    }
    return built;
}

Expected<int> GraphBuilder::slot_number(const SyntaxNode& part, int list) {
    const std::string& name = part.argument.empty() ? part.text : part.argument;
    const auto found = std::find(set_.slots.begin(), set_.slots.end(), name);
    const auto number = static_cast<std::size_t>(found - set_.slots.begin());
    if (found == set_.slots.end()) {
        if (set_.slots.size() >= kMostSlots) {
            return fail(concat({"more than ", std::to_string(kMostSlots), " slots; use fewer"}),
                        part.column);
        }
        set_.slots.push_back(name);
        set_.slot_lists.push_back(list);
    } else if (set_.slot_lists[number] != list) {
        return fail("the slot \"" + name + "\" is filled from two lists; give one another name",
                    part.column);
    }
    return static_cast<int>(number);
}

Expected<std::size_t> GraphBuilder::list_number(const SyntaxNode& part) const {
    const auto found =
        std::find_if(set_.lists.begin(), set_.lists.end(),
                     [&](const WordList& candidate) { return candidate.name == part.text; });
    if (found == set_.lists.end()) {
        return fail("there is no list \"" + part.text + "\"; " + known_lists(set_.lists, part.text),
                    part.column);
    }
    return static_cast<std::size_t>(found - set_.lists.begin());
}

Expected<Built> GraphBuilder::list(const SyntaxNode& part, ArticlePolicy policy, int from,
                                   bool behind_is) {
    if (const auto within = step(part); !within) {
        return tl::unexpected(within.error());
    }
    const auto found = list_number(part);
    if (!found) {
        return tl::unexpected(found.error());
    }
    const auto slot = slot_number(part, static_cast<int>(*found));
    if (!slot) {
        return tl::unexpected(slot.error());
    }
    const std::uint32_t bit = 1U << static_cast<unsigned>(*slot);
    Built built{writer_.add_node(), bit, bit, policy == ArticlePolicy::definite ? bit : 0};
    add_noun_phrase(writer_, set_.lists[*found], *slot, policy, from, built.to, behind_is);
    form_slots_.things = form_slots_.material == kNone ? *slot : form_slots_.things;
    return built;
}

Expected<Built> GraphBuilder::rule(const Syntax& syntax, const SyntaxNode& part, int from,
                                   Neighbours neighbours) {
    const auto found = rules_.find(part.text);
    if (!part.argument.empty() || !part.children.empty() || found == rules_.end()) {
        return form(syntax, part, from, neighbours);
    }
    if (std::find(open_rules_.begin(), open_rules_.end(), part.text) != open_rules_.end()) {
        return fail("the rule <" + part.text + "> uses itself; take one use out", part.column);
    }
    if (open_rules_.size() >= kDeepestRules) {
        return fail(concat({"rules are nested deeper than ", std::to_string(kDeepestRules),
                            "; make them flatter"}),
                    part.column);
    }
    open_rules_.push_back(part.text);
    const auto made = node(found->second, 0, from, neighbours);
    open_rules_.pop_back();
    if (!made) {
        return fail("in <" + part.text + ">: " + made.error().message, part.column);
    }
    return made;
}

}  // namespace fulcrum::dialogue
// NOLINTEND(misc-no-recursion)
