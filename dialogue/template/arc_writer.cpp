#include "dialogue/template/arc_writer.h"

#include "dialogue/template/tokens.h"

#include <algorithm>

namespace fulcrum::dialogue {
namespace {

std::uint8_t standing_of(const ArcText& text) {
    if (text.code == ErrorCode::spelling) {
        return 0;
    }
    return text.canonical ? 2 : 1;
}

}  // namespace

int ArcWriter::add_element(Element element) {
    graph_.elements.push_back(std::move(element));
    return static_cast<int>(graph_.elements.size()) - 1;
}

void ArcWriter::add_arc(int from, int to, int element, const ArcText& text) {
    if (full()) {
        return;
    }
    Arc arc;
    arc.from = from;
    arc.to = to;
    arc.element = element;
    arc.first_word = static_cast<int>(graph_.said.size());
    for (const std::string& word : words_of(text.said)) {
        const int number = set_.words.intern(word);
        set_.standing.resize(static_cast<std::size_t>(set_.words.size()), 0);
        std::uint8_t& standing = set_.standing[static_cast<std::size_t>(number)];
        standing = std::max(standing, standing_of(text));
        graph_.said.push_back(number);
        ++arc.word_count;
    }
    arc.right = text.right.empty() ? kNone : set_.texts.intern(text.right);
    arc.code = text.code;
    arc.cost = text.cost;
    arc.item = text.item;
    arc.number = text.number;
    arc.canonical = text.canonical;
    graph_.arcs.push_back(arc);
}

void ArcWriter::join(int from, int to) {
    if (!full()) {
        Arc arc;
        arc.from = from;
        arc.to = to;
        arc.canonical = true;
        graph_.arcs.push_back(arc);
    }
}

void ArcWriter::add_copy(Arc arc, int from, int to) {
    if (!full()) {
        arc.from = from;
        arc.to = to;
        graph_.arcs.push_back(arc);
    }
}

std::string ArcWriter::said_by(const Arc& arc) const {
    std::string said;
    for (const int word : graph_.said_by(arc)) {
        said += (said.empty() ? "" : " ") + set_.words.text(word);
    }
    return said;
}

std::string ArcWriter::right_of(const Arc& arc) const {
    return arc.right == kNone ? std::string{} : set_.texts.text(arc.right);
}

std::vector<int> ArcWriter::upward_order(int start, int end) const {
    // Depth first from the start without recursion; the reverse of the order of leaving is upward. The
    // last way is taken first, so that what the author wrote first gets the lower numbers and wins where two are equal.
    std::vector<std::vector<int>> next(static_cast<std::size_t>(nodes_));
    for (const Arc& arc : graph_.arcs) {
        next[static_cast<std::size_t>(arc.from)].push_back(arc.to);
    }
    std::vector<int> left;
    std::vector<bool> seen(static_cast<std::size_t>(nodes_), false);
    std::vector<std::pair<int, std::size_t>> stack{{start, 0}};
    seen[static_cast<std::size_t>(start)] = true;
    while (!stack.empty()) {
        auto& [node, at] = stack.back();
        const auto& successors = next[static_cast<std::size_t>(node)];
        if (at == successors.size()) {
            left.push_back(node);
            stack.pop_back();
            continue;
        }
        const int to = successors[successors.size() - ++at];
        if (!seen[static_cast<std::size_t>(to)]) {
            seen[static_cast<std::size_t>(to)] = true;
            stack.emplace_back(to, 0);
        }
    }
    left.erase(std::remove(left.begin(), left.end(), end), left.end());
    std::reverse(left.begin(), left.end());
    left.push_back(end);
    return left;
}

Graph ArcWriter::finish(int start, int end) {
    const std::vector<int> order = upward_order(start, end);
    std::vector<int> rank(static_cast<std::size_t>(nodes_), kNone);
    for (std::size_t i = 0; i < order.size(); ++i) {
        rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    }
    for (Arc& arc : graph_.arcs) {
        arc.from = rank[static_cast<std::size_t>(arc.from)];
        arc.to = rank[static_cast<std::size_t>(arc.to)];
    }
    std::erase_if(graph_.arcs, [](const Arc& arc) { return arc.from == kNone || arc.to == kNone; });
    std::stable_sort(graph_.arcs.begin(), graph_.arcs.end(),
                     [](const Arc& a, const Arc& b) { return a.from < b.from; });
    graph_.first_arc.assign(order.size() + 1, 0);
    for (const Arc& arc : graph_.arcs) {
        ++graph_.first_arc[static_cast<std::size_t>(arc.from) + 1];
    }
    for (std::size_t i = 1; i < graph_.first_arc.size(); ++i) {
        graph_.first_arc[i] += graph_.first_arc[i - 1];
    }
    return std::move(graph_);
}

}  // namespace fulcrum::dialogue
