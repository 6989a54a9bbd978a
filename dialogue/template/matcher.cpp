#include "dialogue/template/matcher.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/hearing.h"
#include "dialogue/template/resolve.h"

#include <algorithm>
#include <limits>

namespace fulcrum::dialogue {
namespace {

constexpr int kUnreached = std::numeric_limits<int>::max();
constexpr int kSkipped = -2;  ///< came here over a filler
constexpr int kDoubled = -3;  ///< came here over a determiner beside another one
constexpr int kSkipCost = 1;  ///< so that a filler is rather said than skipped
constexpr int kSpellingCost = 10;
constexpr int kDoubledCost = 11;  // a slip, but rather any other
constexpr int kNearlyCost = 25;   // a slip or a wrong word in a right sentence is likelier

/// The least cost of each (node, number of words heard), and how it was reached.
class Lattice {
  public:
    Lattice(const Graph& graph, const std::vector<HeardWord>& heard, MatchWork& work)
        : graph_(graph), heard_(heard), work_(work), width_(heard.size() + 1) {
        cells_.resize(static_cast<std::size_t>(graph.nodes()) * width_);
        at(graph.start(), 0).cost = 0;
        for (int node = 0; node < graph.nodes(); ++node) {
            pass(node);
        }
    }

    [[nodiscard]] int cost() const { return cells_.back().cost; }

    /// The arcs of the best path, each with the word it starts at; upwards. No arc: a determiner too many.
    [[nodiscard]] std::vector<std::pair<const Arc*, std::size_t>> path() const {
        std::vector<std::pair<const Arc*, std::size_t>> steps;
        int node = graph_.end();
        std::size_t word = heard_.size();
        while (node != graph_.start() || word != 0) {
            const Cell& cell = cells_[static_cast<std::size_t>(node) * width_ + word];
            if (cell.arc == kSkipped) {
                --word;
                continue;
            }
            if (cell.arc == kDoubled) {
                steps.emplace_back(nullptr, --word);
                continue;
            }
            const Arc& arc = graph_.arcs[static_cast<std::size_t>(cell.arc)];
            word -= static_cast<std::size_t>(arc.word_count);
            node = arc.from;
            steps.emplace_back(&arc, word);
        }
        std::reverse(steps.begin(), steps.end());
        return steps;
    }

  private:
    struct Cell {
        int cost = kUnreached;
        int arc = kNone;
    };
    Cell& at(int node, std::size_t word) {
        return cells_[static_cast<std::size_t>(node) * width_ + word];
    }

    void reach(int node, std::size_t word, int cost, int arc) {
        Cell& cell = at(node, word);
        if (cost < cell.cost && cost <= kGreatestCost) {
            cell = {cost, arc};
        }
    }

    void pass(int node) {
        for (std::size_t word = 0; word < width_; ++word) {
            const int cost = at(node, word).cost;
            if (cost == kUnreached) {
                continue;
            }
            if (word < heard_.size() && heard_[word].filler) {
                reach(node, word + 1, cost + kSkipCost, kSkipped);
            } else if (word < heard_.size() && heard_[word].doubled) {
                reach(node, word + 1, cost + kDoubledCost, kDoubled);
            }
            for (const Arc& arc : graph_.arcs_from(node)) {
                ++work_.steps;
                if (const int slip = says(arc, word); slip >= 0) {
                    reach(arc.to, word + static_cast<std::size_t>(arc.word_count),
                          cost + arc.cost + slip, static_cast<int>(&arc - graph_.arcs.data()));
                }
            }
        }
    }

    /// The cost of the slips in the words from `word` on when they are those of `arc`; -1 when they aren't.
    [[nodiscard]] int says(const Arc& arc, std::size_t word) const {
        const auto said = graph_.said_by(arc);
        if (word + said.size() > heard_.size()) {
            return -1;
        }
        int slips = 0;
        for (std::size_t i = 0; i < said.size(); ++i) {
            if (heard_[word + i].word != said[i]) {
                return -1;
            }
            slips += heard_[word + i].slip == ErrorCode::none ? 0 : kSpellingCost;
        }
        return slips;
    }

    const Graph& graph_;
    const std::vector<HeardWord>& heard_;
    MatchWork& work_;
    std::size_t width_;
    std::vector<Cell> cells_;
};

Piece piece_of(const TemplateSet& set, const Graph& graph, const std::vector<HeardWord>& heard,
               std::string_view utterance, const Arc& arc, std::size_t word) {
    Piece piece;
    piece.element = graph.elements[static_cast<std::size_t>(arc.element)];
    piece.code = arc.code;
    piece.cost = arc.cost;
    piece.right = arc.right == kNone ? std::string{} : set.texts.text(arc.right);
    piece.item = arc.item;
    piece.number = arc.number;
    // The learner's own letters; for something missing, the place before the next word.
    const auto count = static_cast<std::size_t>(arc.word_count);
    piece.begin = word < heard.size() ? heard[word].begin : utterance.size();
    piece.end = count == 0 ? piece.begin : heard[word + count - 1].end;
    piece.said = std::string(utterance.substr(piece.begin, piece.end - piece.begin));
    for (std::size_t i = 0; i < count; ++i) {
        if (!heard[word + i].short_form.empty()) {
            piece.short_form = heard[word + i].short_form;
            piece.goes_on = i + 1 == count;
        }
        const ErrorCode slip = heard[word + i].slip;
        if (slip == ErrorCode::none) {
            continue;
        }
        piece.cost += kSpellingCost;
        if (piece.code == ErrorCode::none) {
            piece.code = slip;
        }
    }
    return piece;
}

/// The one of two determiners that doesn't belong there.
Piece doubled_piece(const HeardWord& word, std::string_view utterance) {
    Piece piece;
    piece.element.role = Role::determiner;
    piece.code = ErrorCode::extra_determiner;
    piece.cost = kDoubledCost;
    piece.begin = word.begin;
    piece.end = word.end;
    piece.said = std::string(utterance.substr(word.begin, word.end - word.begin));
    return piece;
}

Parse parse_of(const TemplateSet& set, int number, const Lattice& lattice,
               const std::vector<HeardWord>& heard, std::string_view utterance) {
    const Graph& graph = set.graphs[static_cast<std::size_t>(number)];
    Parse parse;
    parse.graph = number;
    for (const auto& [arc, word] : lattice.path()) {
        if (arc == nullptr) {
            parse.pieces.push_back(doubled_piece(heard[word], utterance));
        } else if (arc->element != kNone) {
            parse.pieces.push_back(piece_of(set, graph, heard, utterance, *arc, word));
        }
    }
    resolve(parse.pieces);
    parse.cost = total_cost(parse.pieces) + (graph.nearly ? kNearlyCost : 0);
    for (const Piece& piece : parse.pieces) {
        parse.leaves_out = parse.leaves_out || (piece.element.role == Role::noun &&
                                                !piece.element.base.empty() && piece.right.empty());
        if (piece.element.slot != kNone) {
            const auto slot = static_cast<std::size_t>(piece.element.slot);
            const WordList& list = set.lists[static_cast<std::size_t>(set.slot_lists[slot])];
            parse.slots.emplace_back(set.slots[slot],
                                     list.items[static_cast<std::size_t>(piece.item)].value);
        }
    }
    return parse;
}

}  // namespace

namespace {

/// Whether a path of `graph` could say them all: it has each word that cannot be passed over. Most graphs have not, and need no lattice.
bool has_words(const Graph& graph, const std::vector<HeardWord>& heard) {
    return std::all_of(heard.begin(), heard.end(), [&](const HeardWord& word) {
        return word.filler || word.doubled || graph.says[static_cast<std::size_t>(word.word)];
    });
}

/// The best parse of the words as they were heard, or none.
std::optional<Parse> match_heard(const TemplateSet& set, const std::vector<HeardWord>& heard,
                                 std::string_view utterance, MatchWork& counted) {
    if (heard.empty() || heard.size() > kMostWords) {
        return std::nullopt;
    }
    // A word that is neither known nor a filler: nothing can match.
    if (std::any_of(heard.begin(), heard.end(), [](const HeardWord& word) {
            return word.word == kNone && !word.filler && !word.doubled;
        })) {
        return std::nullopt;
    }
    std::optional<Parse> best;
    for (int number = 0; number < static_cast<int>(set.graphs.size()); ++number) {
        const Graph& graph = set.graphs[static_cast<std::size_t>(number)];
        if ((graph.turned_round && best) ||  // only where nothing else is meant
            !has_words(graph, heard)) {
            continue;
        }
        const Lattice lattice(graph, heard, counted);
        if (lattice.cost() == kUnreached) {
            continue;
        }
        Parse parse = parse_of(set, number, lattice, heard, utterance);
        // What is said whole goes before what leaves something out.
        if (!best || parse.cost < best->cost ||
            (parse.cost == best->cost && best->leaves_out && !parse.leaves_out)) {
            best = std::move(parse);
        }
    }
    if (best) {
        const auto first = std::find_if(heard.begin(), heard.end(),
                                        [](const HeardWord& word) { return word.unread; });
        best->unread = first == heard.end() ? utterance.size() : first->begin;
    }
    return best;
}

}  // namespace

std::optional<Parse> match(const TemplateSet& set, std::string_view utterance, MatchWork* work) {
    MatchWork own;
    MatchWork& counted = work != nullptr ? *work : own;
    if (utterance.size() > kLongestUtterance_bytes) {
        return std::nullopt;
    }
    auto best =
        match_heard(set, hear_words(set, utterance, counted.comparisons), utterance, counted);
    if (its_is_open(set, utterance) && (!best || best->cost > 0)) {
        auto other = match_heard(set, hear_words(set, utterance, counted.comparisons, Its::owner),
                                 utterance, counted);
        if (other && (!best || other->cost < best->cost)) {
            best = std::move(other);
        }
    }
    if (!best && has_consequence(set, utterance)) {
        best = match_heard(
            set, hear_words(set, utterance, counted.comparisons, Its::contraction, Reason::so_too),
            utterance, counted);
    }
    return best;
}

}  // namespace fulcrum::dialogue
