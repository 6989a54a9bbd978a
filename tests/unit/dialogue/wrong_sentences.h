// Sentences with one or two labelled errors, made from a template's graphs, and what is looked for in all of them.
#pragma once

#include "dialogue/english/determiner.h"
#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/graph.h"
#include "dialogue/template/tokens.h"
#include "tests/unit/dialogue/rig.h"

namespace fulcrum::dialogue {

/// Two determiners side by side in `text`, or "".
inline std::string doubled_determiner(const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (is_sole_determiner(words[i - 1]) && is_sole_determiner(words[i])) {
            return words[i - 1] + " " + words[i];
        }
    }
    return {};
}

/// Two determiners side by side on any way of arcs without an error through `graph`; exact, for it asks of every node with
/// which determiners a way to it may end.
inline std::string right_doubled_determiner(const TemplateSet& set, const Graph& graph) {
    std::vector<std::set<std::string>> ends(static_cast<std::size_t>(graph.nodes()));
    std::vector<bool> reached(ends.size(), false);
    reached[0] = true;
    for (const Arc& arc : graph.arcs) {
        const auto from = static_cast<std::size_t>(arc.from);
        const auto to = static_cast<std::size_t>(arc.to);
        if (arc.code != ErrorCode::none || !reached[from]) {
            continue;
        }
        reached[to] = true;
        std::set<std::string> last = ends[from];
        for (const int number : graph.said_by(arc)) {
            const std::string& word = set.words.text(number);
            const bool is_one = is_sole_determiner(word);
            if (is_one && !last.empty()) {
                return *last.begin() + " " + word;
            }
            last = is_one ? std::set<std::string>{word} : std::set<std::string>{};
        }
        ends[to].insert(last.begin(), last.end());
    }
    return {};
}

/// The words of the way without errors from one node to another, what a recast says before other words; false where there is none.
inline bool append_right_way(const TemplateSet& set, const Graph& graph, int from, int to,
                             std::string& said) {
    constexpr int kFar = 1'000'000;
    constexpr int kOtherWords = 20;  // rather so many words more than one that a recast doesn't say
    std::vector<int> rest(static_cast<std::size_t>(graph.nodes()), kFar);
    std::vector<const Arc*> next(rest.size(), nullptr);
    rest[static_cast<std::size_t>(to)] = 0;
    for (int node = to - 1; node >= from; --node) {
        for (const Arc& arc : graph.arcs_from(node)) {
            const int price = rest[static_cast<std::size_t>(arc.to)] + arc.word_count +
                              (arc.canonical ? 0 : kOtherWords);
            if (arc.code == ErrorCode::none && price < rest[static_cast<std::size_t>(node)]) {
                rest[static_cast<std::size_t>(node)] = price;
                next[static_cast<std::size_t>(node)] = &arc;
            }
        }
    }
    for (int node = from; node != to;) {
        const Arc* arc = next[static_cast<std::size_t>(node)];
        if (arc == nullptr) {
            return false;
        }
        for (const int word : graph.said_by(*arc)) {
            said += (said.empty() ? "" : " ") + set.words.text(word);
        }
        node = arc->to;
    }
    return true;
}

/// Calls `look` with a sentence for each labelled error of `graph`, of those with one correction the first, and for each two
/// of them that fit into one, every so many where there are thousands; errors of the kind `but` are left out.
inline void each_wrong_sentence(const TemplateSet& set, const Graph& graph,
                                const std::function<void(const std::string&)>& look,
                                ErrorCode but = ErrorCode::none) {
    std::vector<const Arc*> wrong;
    std::set<std::tuple<int, int, ErrorCode, int>> kinds;
    for (const Arc& arc : graph.arcs) {
        if (arc.code != ErrorCode::none && arc.code != but &&
            kinds.emplace(arc.from, arc.to, arc.code, arc.right).second) {
            wrong.push_back(&arc);
        }
    }
    const auto say = [&](std::vector<const Arc*> errors) {
        std::string said;
        int at = graph.start();
        for (const Arc* arc : errors) {
            if (!append_right_way(set, graph, at, arc->from, said)) {
                return;
            }
            for (const int word : graph.said_by(*arc)) {
                said += (said.empty() ? "" : " ") + set.words.text(word);
            }
            at = arc->to;
        }
        if (append_right_way(set, graph, at, graph.end(), said)) {
            look(said);
        }
    };
    constexpr std::size_t kMostPairs = 1'500;
    const std::size_t every = 1 + wrong.size() * wrong.size() / 2 / kMostPairs;
    std::size_t n_pairs = 0;
    for (const Arc* first : wrong) {
        say({first});
        for (const Arc* second : wrong) {
            if (second->from >= first->to && n_pairs++ % every == 0) {
                say({first, second});
            }
        }
    }
}

/// What is wrong with what is said back to those sentences, as one text; "" for nothing. `n_tried` counts them.
inline std::string wrong_recasts(const Question& question, int& n_tried) {
    const TemplateSet& set = *question.templates;
    std::set<std::string> recasts;
    std::string found;
    for (const Graph& graph : set.graphs) {
        if (graph.nearly || graph.turned_round) {
            continue;
        }
        each_wrong_sentence(set, graph, [&](const std::string& said) {
            ++n_tried;
            const Mark mark = mark_answer(question, said);
            if (!mark.understood || !recasts.insert(mark.corrected).second) {
                found += mark.understood ? "" : said + ": not understood\n";
                return;
            }
            const Mark again = mark_answer(question, mark.corrected);
            if (!doubled_determiner(mark.corrected).empty() || !again.understood ||
                !again.form_right()) {
                found += said + " -> " + mark.emphasised + " -> " + again.emphasised + "\n";
            }
        });
    }
    return found;
}

}  // namespace fulcrum::dialogue
