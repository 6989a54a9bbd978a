#include "dialogue/template/word_order.h"

#include "dialogue/template/phrases.h"

#include <map>
#include <set>
#include <vector>

namespace fulcrum::dialogue {
namespace {

/// What may stand between a verb and its place at the end.
bool is_copied(const Arc& arc) {
    return arc.code == ErrorCode::none || arc.code == ErrorCode::missing_determiner;
}

/// The nodes that the arcs lead to from `node`; against their direction when `back`.
std::set<int> reached_from(const std::vector<Arc>& arcs, int node, bool back) {
    std::map<int, std::vector<int>> next;
    for (const Arc& arc : arcs) {
        next[back ? arc.to : arc.from].push_back(back ? arc.from : arc.to);
    }
    std::set<int> seen{node};
    std::vector<int> open{node};
    while (!open.empty()) {
        const int at = open.back();
        open.pop_back();
        for (const int to : next[at]) {
            if (seen.insert(to).second) {
                open.push_back(to);
            }
        }
    }
    return seen;
}

/// The arcs to copy between `node` and `end`.
std::vector<Arc> arcs_between(std::vector<Arc> arcs, int node, int end) {
    std::erase_if(arcs, [](const Arc& arc) { return !is_copied(arc); });
    const std::set<int> behind = reached_from(arcs, node, false);
    const std::set<int> before_end = reached_from(arcs, end, true);
    std::erase_if(arcs, [&](const Arc& arc) {
        return !behind.contains(arc.from) || !before_end.contains(arc.to);
    });
    return arcs;
}

/// "Is" of `verb` behind all that follows it.
void move_to_end(ArcWriter& writer, const std::vector<Arc>& arcs, const Arc& verb, int end) {
    const std::vector<Arc> behind = arcs_between(arcs, verb.to, end);
    constexpr std::size_t kRoom = 8;  // the arcs of the verb itself
    if (writer.room() < behind.size() + kRoom) {
        return;
    }
    std::map<int, int> copies;
    const auto copy_of = [&](int node) {
        const auto [entry, is_new] = copies.try_emplace(node, kNone);
        entry->second = is_new ? writer.add_node() : entry->second;
        return entry->second;
    };
    writer.add_arc(verb.from, copy_of(verb.to), verb.element,
                   {"", writer.right_of(verb), ErrorCode::word_order, kOrderCost});
    for (const Arc& arc : behind) {
        writer.add_copy(arc, copy_of(arc.from), copy_of(arc.to));
    }
    const int late = writer.add_element({Role::word});
    for (const Arc& form : arcs) {
        const bool is_form = form.code == ErrorCode::none || form.code == ErrorCode::agreement;
        if (form.from == verb.from && form.element == verb.element && form.word_count > 0 &&
            is_form) {
            writer.add_arc(copy_of(end), end, late,
                           {writer.said_by(form), "", ErrorCode::none, 0, true});
        }
    }
}

}  // namespace

void add_verb_last(ArcWriter& writer, int start, int end) {
    const std::vector<Arc> arcs = writer.arcs();
    for (const Arc& arc : arcs) {
        const bool is_verb = arc.element != kNone && arc.canonical && arc.word_count > 0 &&
                             writer.element(arc.element).role == Role::verb &&
                             !writer.element(arc.element).passive;
        if (is_verb && arc.from != start) {
            move_to_end(writer, arcs, arc, end);
        }
    }
}

}  // namespace fulcrum::dialogue
