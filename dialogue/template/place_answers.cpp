#include "dialogue/template/place_answers.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/short_answers.h"
#include "dialogue/template/what_follows.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace fulcrum::dialogue {
namespace {

using PartKind = SyntaxNode::Kind;

/// How a place is told alone; empty where English needs what it is a place of.
std::string alone(const std::string& place) {
    constexpr std::array<std::string_view, 10> kAlone = {
        "above",   "below",  "underneath", "beneath", "inside",
        "outside", "behind", "between",    "nearby",  "opposite"};
    if (place.ends_with(" of")) {
        return place.substr(0, place.size() - 3);
    }
    const bool is_alone = std::ranges::find(kAlone, place) != kAlone.end();
    return is_alone ? (place == "between" ? "in between" : place) : std::string();
}

/// Where a sentence says "{place} the {thing}" at its end.
struct PlaceOfThing {
    std::size_t column = 0;    ///< of the place
    std::string place, thing;  ///< their slots
};

std::string slot_name(const SyntaxNode& list) {
    return list.argument.empty() ? list.text : list.argument;
}

bool is_article_part(const Syntax& syntax, int index) {
    const SyntaxNode& node = unwrapped(syntax, index);
    if (node.kind == PartKind::word) {
        return is_article(node.text);
    }
    return !node.children.empty() && std::ranges::all_of(node.children, [&](int child) {
        const SyntaxNode& inner = unwrapped(syntax, child);
        return inner.kind == PartKind::word && is_article(inner.text);
    });
}

std::optional<PlaceOfThing> find_place(const Syntax& syntax) {
    const SyntaxNode& whole = syntax[0];
    if (whole.kind != PartKind::alternatives || whole.children.size() != 1) {
        return std::nullopt;
    }
    const std::vector<int>& parts = part_at(syntax, whole.children[0]).children;
    std::size_t n = parts.size();
    if (n < 2 || unwrapped(syntax, parts[n - 1]).kind != PartKind::list) {
        return std::nullopt;
    }
    const SyntaxNode& thing = unwrapped(syntax, parts[n - 1]);
    n -= n > 2 && is_article_part(syntax, parts[n - 2]) ? 2 : 1;
    const SyntaxNode& place = unwrapped(syntax, parts[n - 1]);
    if (place.kind != PartKind::list) {
        return std::nullopt;
    }
    return PlaceOfThing{static_cast<std::size_t>(place.column) - 1, slot_name(place),
                        slot_name(thing)};
}

int find_slot(const TemplateSet& set, const std::string& name) {
    const auto found = std::ranges::find(set.slots, name);
    return found == set.slots.end() ? kNone : static_cast<int>(found - set.slots.begin());
}

/// The places of `slot` that may be told alone, as a list of its own; kNone for none.
int add_list_alone(TemplateSet& set, int slot, const std::string& name) {
    const auto own = static_cast<std::size_t>(set.slot_lists[static_cast<std::size_t>(slot)]);
    WordList list{name, {}};
    for (const ListItem& item : set.lists[own].items) {
        ListItem told{item.value, {}};
        for (const Noun& noun : item.spoken) {
            if (noun.noun_class != NounClass::no_noun) {
                return kNone;  // these are no places
            }
            if (std::string words = alone(lower_case(noun.text)); !words.empty()) {
                told.spoken.push_back({std::move(words), NounClass::no_noun});
            }
        }
        if (!told.spoken.empty()) {
            list.items.push_back(std::move(told));
        }
    }
    if (list.items.empty()) {
        return kNone;
    }
    set.lists.push_back(std::move(list));
    return static_cast<int>(set.lists.size()) - 1;
}

/// All of the list's entries are places, "on top", and nothing that has an article.
bool are_places(const WordList& list) {
    return std::ranges::all_of(list.items, [](const ListItem& item) {
        return item.spoken.front().noun_class == NounClass::no_noun;
    });
}

/// `text` is short for answer `answer`, of whatever word of slot `thing` it is true.
void add_of_any(TemplateSet& set, const ParsedRules& rules, const std::string& text, int answer,
                int thing) {
    auto built = build_sentence(set, rules, text);
    if (!built) {
        return;
    }
    built->graph.answer = answer;
    built->graph.claim = Claim::of_any;
    built->graph.about = thing;
    built->graph.short_answer = true;
    set.graphs.push_back(std::move(built->graph));
}

}  // namespace

void add_place_answers(TemplateSet& set, const ParsedRules& rules,
                       const std::vector<std::string>& sentences) {
    constexpr std::string_view kListAlone = "place_told_alone";
    for (std::size_t i = 0; i < sentences.size(); ++i) {
        const auto syntax = parse_template(sentences[i]);
        const auto found = syntax ? find_place(*syntax) : std::nullopt;
        const int place = found ? find_slot(set, found->place) : kNone;
        const int thing = found ? find_slot(set, found->thing) : kNone;
        if (place == kNone || thing == kNone || arcs_left(set) < 3 * set.graphs[i].arcs.size()) {
            continue;
        }
        const auto keep = [&](const std::string& text) {
            add_of_any(set, rules, text, static_cast<int>(i), thing);
        };
        const std::string head = sentences[i].substr(0, found->column);
        const std::string name = concat({kListAlone, "_", std::to_string(i)});
        const std::size_t n_lists = set.lists.size();
        const int alone_list = add_list_alone(set, place, name);
        if (alone_list != kNone) {
            keep(concat({head, "{", name, "}"}));
            const int twin = find_slot(set, name);
            if (twin != kNone) {
                set.slots[static_cast<std::size_t>(twin)] = found->place;
            } else {
                set.lists.resize(n_lists);
            }
        }
        const std::string own = sentences[i].substr(
            found->column, sentences[i].find('}', found->column) + 1 - found->column);
        const auto number =
            static_cast<std::size_t>(set.slot_lists[static_cast<std::size_t>(place)]);
        if (are_places(set.lists[number])) {
            keep(concat({head, own, " it"}));
        }
    }
}

}  // namespace fulcrum::dialogue
