#include "dialogue/speech/word_graph.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/number.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace fulcrum::dialogue {
namespace {

// Differences that an ear does not hear.
bool is_heard(ErrorCode code) {
    return code != ErrorCode::spelling && code != ErrorCode::orthography;
}

// Without stress "then" sounds as "than" does: nobody can tell which of them was meant.
bool sounds_right(std::string_view said, std::string_view right) {
    return said == "then" && right == "than";
}

// "21" is said as "twenty one".
void add_spoken(const std::string& word, std::vector<std::string>& to) {
    long number = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
    if (read.ec == std::errc{} && read.ptr == word.data() + word.size()) {
        const std::vector<std::string> parts = number_words(number);
        to.insert(to.end(), parts.begin(), parts.end());
        if (!parts.empty()) {
            return;
        }
    }
    to.push_back(lower_case(word));
}

class Writer {
  public:
    explicit Writer(const TemplateSet& set) : set_(set) {}

    WordGraph write() {
        int next = 1;
        for (int i = 0; std::cmp_less(i, set_.graphs.size()); ++i) {
            first_.push_back(next);
            next += follows_by_english(i) ? 0 : set_.graphs[static_cast<std::size_t>(i)].nodes();
        }
        const int end = next;
        next_ = next + 1;
        for (std::size_t i = 0; i < set_.graphs.size(); ++i) {
            const Graph& graph = set_.graphs[i];
            if (follows_by_english(static_cast<int>(i))) {
                continue;
            }
            add(0, first_[i] + graph.start(), kNone, 1.0);
            add(first_[i] + graph.end(), end, kNone, 1.0);
            for (const Arc& arc : graph.arcs) {
                add_arc(graph, first_[i], arc);
            }
        }
        // The end is the last.
        for (const auto& [key, weight] : arcs_) {
            const auto& [from, to, word] = key;
            graph_.arcs.push_back({renumber(from, end), renumber(to, end), word, weight});
        }
        graph_.nodes = next_;
        return std::move(graph_);
    }

  private:
    /// Made of an author's sentence (template/variants.h, place_answers.h). With all of those a recogniser of closed vocabulary is too slow.
    [[nodiscard]] bool follows_by_english(int number) const {
        const Graph& graph = set_.graphs[static_cast<std::size_t>(number)];
        const bool short_or_else = graph.short_answer || graph.nearly || graph.turned_round;
        return number >= set_.answers && (graph.claim != Claim::same || !short_or_else);
    }

    [[nodiscard]] int renumber(int node, int end) const {
        return node == end ? next_ - 1 : node - (node > end ? 1 : 0);
    }

    void add_arc(const Graph& graph, int first, const Arc& arc) {
        if (!is_heard(arc.code)) {
            return;
        }
        std::vector<std::string> spoken;
        for (const int word : graph.said_by(arc)) {
            add_spoken(set_.words.text(word), spoken);
        }
        const std::string_view right =
            arc.right == kNone ? std::string_view() : set_.texts.text(arc.right);
        if (spoken.size() == 1 && sounds_right(spoken.front(), right)) {
            return;
        }
        const double weight = arc.code == ErrorCode::none ? 1.0 : kErrorWeight;
        int from = first + arc.from;
        const int to = first + arc.to;
        if (spoken.empty()) {
            add(from, to, kNone, weight);
            return;
        }
        // Several words that are said at one place share what they begin with.
        for (std::size_t i = 0; i < spoken.size(); ++i) {
            const int word = find_word(spoken[i]);
            const bool is_last = i + 1 == spoken.size();
            from =
                is_last ? (add(from, to, word, weight), to) : find_middle(from, to, word, weight);
        }
    }

    int find_word(const std::string& text) {
        const auto [found, is_new] = numbers_.emplace(text, static_cast<int>(graph_.words.size()));
        if (is_new) {
            graph_.words.push_back(text);
        }
        return found->second;
    }

    int find_middle(int from, int to, int word, double weight) {
        const auto [found, is_new] = middles_.emplace(std::tuple{from, to, word}, next_);
        next_ += is_new ? 1 : 0;
        add(from, found->second, word, weight);
        return found->second;
    }

    void add(int from, int to, int word, double weight) {
        double& known = arcs_[{from, to, word}];
        known = std::max(known, weight);
    }

    const TemplateSet& set_;
    WordGraph graph_;
    std::vector<int> first_;  // node of each graph
    int next_ = 0;
    std::map<std::string, int, std::less<>> numbers_;
    std::map<std::tuple<int, int, int>, int>
        middles_;  // of what is said in several words at one place
    std::map<std::tuple<int, int, int>, double> arcs_;
};

}  // namespace

WordGraph make_word_graph(const TemplateSet& set) {
    return Writer(set).write();
}

}  // namespace fulcrum::dialogue
