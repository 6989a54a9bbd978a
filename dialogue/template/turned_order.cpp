#include "dialogue/template/turned_order.h"

#include "dialogue/template/short_answers.h"

#include <cstddef>
#include <string_view>
#include <utility>

namespace fulcrum::dialogue {
namespace {

using Kind = SyntaxNode::Kind;

const SyntaxNode& node_at(const Syntax& syntax, int index) {
    return syntax[static_cast<std::size_t>(index)];
}

bool is_verb_of(const SyntaxNode& part) {
    return part.kind == Kind::word && (part.text == "is" || part.text == "are");
}

/// "Heavier is the egg", "is heavier the egg"; none of a sentence that isn't built so.
std::vector<std::string> turned(const std::string& text, const Syntax& syntax) {
    const SyntaxNode* whole = &node_at(syntax, 0);
    while ((whole->kind == Kind::alternatives || whole->kind == Kind::sequence) &&
           whole->children.size() == 1) {
        whole = &node_at(syntax, whole->children[0]);
    }
    const std::vector<int>& parts = whole->children;
    const auto begin_of = [&](std::size_t i) {
        return i < parts.size() ? static_cast<std::size_t>(node_at(syntax, parts[i]).column) - 1
                                : text.size();
    };
    for (std::size_t i = 1; whole->kind == Kind::sequence && i + 1 < parts.size(); ++i) {
        const SyntaxNode& compared = node_at(syntax, parts[i + 1]);
        // Behind a pronoun nothing is named that could come last.
        const bool named = node_at(syntax, parts[i - 1]).kind == Kind::list;
        if (named && is_verb_of(node_at(syntax, parts[i])) && compared.kind == Kind::rule &&
            compared.text == "comparative") {
            const std::string subject = text.substr(0, begin_of(i));
            const std::string verb = text.substr(begin_of(i), begin_of(i + 1) - begin_of(i));
            const std::string degree =
                text.substr(begin_of(i + 1), begin_of(i + 2) - begin_of(i + 1));
            const std::string rest = text.substr(begin_of(i + 2));
            return {concat({degree, " ", verb, " ", subject, " ", rest}),
                    concat({verb, " ", degree, " ", subject, " ", rest})};
        }
    }
    return {};
}

}  // namespace

void add_turned_order(TemplateSet& set, const ParsedRules& rules,
                      const std::vector<std::string>& sentences) {
    constexpr std::size_t kRoom = 4;  // times what a sentence takes: short answers come behind
    for (std::size_t i = 0; i < sentences.size(); ++i) {
        const auto syntax = parse_template(sentences[i]);
        if (!syntax || arcs_left(set) < kRoom * set.graphs[i].arcs.size()) {
            continue;
        }
        for (const std::string& text : turned(sentences[i], *syntax)) {
            auto sentence = build_sentence(set, rules, text);
            if (!sentence) {
                continue;  // "is" alone would be left
            }
            Graph& graph = sentence->graph;
            graph.answer = static_cast<int>(i);
            graph.answers = {graph.answer};
            graph.nearly = true;
            graph.whole_sentence = false;
            set.graphs.push_back(std::move(graph));
        }
    }
}

}  // namespace fulcrum::dialogue
