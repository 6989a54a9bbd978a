// The forms of grammar in a template: <superlative:heavy>, <comparative:{feel}>, <made_of:{material}> and their like.
#include "dialogue/english/letters.h"
#include "dialogue/template/graph_builder.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr std::string_view kForms =
    "<adjective:word>, <comparative:word>, <superlative:word>, <made_of:word>, <plural:word>, "
    "<article>, <it>; a {list} may stand for an adjective or a material";

constexpr std::array<std::string_view, 5> kNeedWord = {"adjective", "comparative", "superlative",
                                                       "made_of", "plural"};

bool needs_word(std::string_view form) {
    return std::find(kNeedWord.begin(), kNeedWord.end(), form) != kNeedWord.end();
}

/// The rule that was meant by a name that none has; empty for none.
std::string_view nearest_rule(const ParsedRules& rules, std::string_view name) {
    std::string_view nearest;
    int least = 3;
    for (const auto& [rule, syntax] : rules) {
        if (const int distance = edit_distance(rule, name); distance < least) {
            least = distance;
            nearest = rule;
        }
    }
    return nearest;
}

/// Names that authors give to a form or a rule that there is.
tl::unexpected<Error> no_such_form(const SyntaxNode& part, const ParsedRules& rules) {
    const bool with_word = !part.argument.empty() || !part.children.empty();
    if (const std::string_view rule = nearest_rule(rules, part.text); !rule.empty()) {
        return with_word && rule == part.text
                   ? fail(concat({"the rule <", rule, "> takes no word; take it out"}), part.column)
                   : fail(
                         concat({"there is no rule <", part.text, ">; did you mean <", rule, ">?"}),
                         part.column);
    }
    std::string_view nearest;
    int least = 4;
    for (const std::string_view form : kNeedWord) {
        if (const int distance = edit_distance(form, part.text); distance < least) {
            least = distance;
            nearest = form;
        }
    }
    const std::string name = concat({"<", part.text, with_word ? ":…>" : ">"});
    if (nearest == part.text) {
        return fail(concat({name, " needs a word: <", nearest, ":word>"}), part.column);
    }
    if (!nearest.empty()) {
        return fail(concat({"there is no form ", name, "; did you mean <", nearest, ":word>?"}),
                    part.column);
    }
    return fail(concat({"there is no form ", name, "; forms are ", kForms}), part.column);
}

}  // namespace

/// The words that a form may take, and the slot that they fill.
struct GraphBuilder::Words {
    const WordList* list = nullptr;
    int slot = kNone;
    WordList own{};  ///< the one word of <form:word>

    [[nodiscard]] const WordList& words() const { return list != nullptr ? *list : own; }
    [[nodiscard]] std::uint32_t bits() const {
        return slot == kNone ? 0 : 1U << static_cast<unsigned>(slot);
    }
};

Expected<GraphBuilder::Words> GraphBuilder::words_of_form(const Syntax& syntax,
                                                          const SyntaxNode& part) {
    Words words;
    if (part.children.empty()) {
        Noun noun = understand_noun(part.argument);
        noun.text = part.argument;
        words.own.items.push_back({part.argument, {std::move(noun)}});
        return words;
    }
    const SyntaxNode& child = syntax[static_cast<std::size_t>(part.children[0])];
    const auto found = list_number(child);
    if (!found) {
        return tl::unexpected(found.error());
    }
    const auto slot = slot_number(child, static_cast<int>(*found));
    if (!slot) {
        return tl::unexpected(slot.error());
    }
    words.list = &set_.lists[*found];
    words.slot = *slot;
    return words;
}

Expected<Built> GraphBuilder::degree(const Syntax& syntax, const SyntaxNode& part, Degree degree,
                                     int from, Neighbours neighbours) {
    const auto words = words_of_form(syntax, part);
    if (!words) {
        return tl::unexpected(words.error());
    }
    Built built{writer_.add_node(), words->bits(), words->bits()};
    add_degree(writer_, words->words(), words->slot, degree, neighbours.after_article, from,
               built.to);
    if (degree == Degree::superlative && neighbours.closes) {
        built.to = add_of_all(writer_, OneToo::yes, built.to);
    } else if (degree == Degree::comparative && neighbours.before_than) {
        built.to = add_late_is(writer_, built.to);
    }
    if (degree == Degree::positive && words->slot != kNone) {
        form_slots_.adjectives.push_back(words->slot);
    }
    return built;
}

Expected<Built> GraphBuilder::made_of(const Syntax& syntax, const SyntaxNode& part, int from,
                                      Neighbours neighbours) {
    const auto words = words_of_form(syntax, part);
    if (!words) {
        return tl::unexpected(words.error());
    }
    const int material =
        add_made_of(writer_, neighbours, neighbours.after_it ? Making::late : Making::plain, from);
    form_slots_.subject = neighbours.subject;
    const int made_of = writer_.add_node();
    add_material(writer_, words->words(), words->slot, material, made_of);
    const Built built{add_made_last(writer_, made_of), words->bits(), words->bits()};
    form_slots_.material = words->slot;
    return built;
}

Expected<Built> GraphBuilder::form(const Syntax& syntax, const SyntaxNode& part, int from,
                                   Neighbours neighbours) {
    const std::string& name = part.text;
    const bool with_list = !part.children.empty();
    const bool with_word = with_list || !part.argument.empty();
    if (with_word != needs_word(name)) {
        const bool known = with_word && (name == "article" || name == "it");
        return known ? fail("<" + name + "> takes no word; take it out", part.column)
                     : no_such_form(part, rules_);
    }
    if (name == "made_of") {
        return made_of(syntax, part, from, neighbours);
    }
    for (const auto& [form, kind] : {std::pair{"adjective", Degree::positive},
                                     {"comparative", Degree::comparative},
                                     {"superlative", Degree::superlative}}) {
        if (name == form) {
            return degree(syntax, part, kind, from, neighbours);
        }
    }
    Built built{writer_.add_node()};
    if (name == "plural" && !with_list) {
        add_plural(writer_, part.argument, neighbours.after_list, from, built.to);
    } else if (name == "article") {
        add_article(writer_, {}, neighbours.noun, from, built.to);
    } else if (name == "it") {
        add_it(writer_, pronoun_, from, built.to);
    } else {
        return with_list ? fail("<plural:…> takes a word, not a list; write the word", part.column)
                         : no_such_form(part, rules_);
    }
    return built;
}

}  // namespace fulcrum::dialogue
