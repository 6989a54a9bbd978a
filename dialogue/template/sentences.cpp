#include "dialogue/template/sentences.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/phrases.h"
#include "dialogue/template/resolve.h"
#include "dialogue/template/slot_entries.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr std::string_view kGap = "…";

/// A sentence that asks ends with a question mark.
bool asks(const std::string& sentence) {
    constexpr std::array<std::string_view, 14> kAsking = {"how",   "what", "which", "where", "who",
                                                          "whose", "why",  "is",    "are",   "am",
                                                          "was",   "were", "does",  "can"};
    std::string first = lower_case(sentence.substr(0, sentence.find(' ')));
    std::erase(first, '*');
    first = first.ends_with("n't") ? first.substr(0, first.size() - 3) : first;
    return std::find(kAsking.begin(), kAsking.end(), first) != kAsking.end();
}

const WordList& list_of(const TemplateSet& set, int slot) {
    return set.lists[static_cast<std::size_t>(set.slot_lists[static_cast<std::size_t>(slot)])];
}

/// The nodes from which the end can be reached, over right arcs only or over all.
std::vector<bool> leads_to_end(const Graph& graph, bool errors) {
    std::vector<bool> leads(static_cast<std::size_t>(graph.nodes()), false);
    leads.back() = true;
    for (auto arc = graph.arcs.rbegin(); arc != graph.arcs.rend(); ++arc) {
        if ((errors || arc->code == ErrorCode::none) && leads[static_cast<std::size_t>(arc->to)]) {
            leads[static_cast<std::size_t>(arc->from)] = true;
        }
    }
    return leads;
}

/// Part of the sentence that a recast gives.
bool is_plain(const Arc& arc) {
    return arc.canonical && arc.code == ErrorCode::none;
}

/// The nodes from which the end can be reached over such arcs.
std::vector<bool> leads_plainly(const Graph& graph) {
    std::vector<bool> leads(static_cast<std::size_t>(graph.nodes()), false);
    leads.back() = true;
    for (auto arc = graph.arcs.rbegin(); arc != graph.arcs.rend(); ++arc) {
        if (is_plain(*arc) && leads[static_cast<std::size_t>(arc->to)]) {
            leads[static_cast<std::size_t>(arc->from)] = true;
        }
    }
    return leads;
}

Piece right_piece(const TemplateSet& set, const Graph& graph, const Arc& arc) {
    Piece piece;
    piece.element = graph.elements[static_cast<std::size_t>(arc.element)];
    piece.code = arc.code;
    piece.cost = arc.cost;
    piece.right = arc.right == kNone ? std::string{} : set.texts.text(arc.right);
    piece.item = arc.item;
    piece.number = arc.number;
    return piece;
}

std::string said_by(const TemplateSet& set, const Graph& graph, const Arc& arc) {
    std::string said;
    for (const int word : graph.said_by(arc)) {
        said += (said.empty() ? "" : " ") + set.words.text(word);
    }
    return said;
}

/// Writes what the sample's pieces say, or what belongs there when it has no errors, and what they mean.
void describe(const TemplateSet& set, bool errors, Sample& sample) {
    for (const Piece& piece : sample.pieces) {
        const std::string& text = errors ? piece.said : piece.right;
        if (!text.empty()) {
            sample.said += (sample.said.empty() ? "" : " ") + text;
        }
        const int slot = piece.element.slot;
        if (slot != kNone) {
            sample.slots.emplace_back(
                set.slots[static_cast<std::size_t>(slot)],
                list_of(set, slot).items[static_cast<std::size_t>(piece.item)].value);
        }
    }
}

/// Says what the arc has; the node that it leads to.
int go_on(const TemplateSet& set, const Graph& graph, const Arc& arc, Sample& sample) {
    if (arc.element != kNone) {
        sample.pieces.push_back(right_piece(set, graph, arc));
        sample.pieces.back().said = said_by(set, graph, arc);
    }
    return arc.to;
}

}  // namespace

namespace {

/// Without the ending of a form: "stopped", "stops", "turning", "harder".
std::string_view stem_of(std::string_view word) {
    constexpr std::size_t kShortestStem = 3;
    for (const std::string_view ending : {"ing", "ed", "er", "es", "s"}) {
        const bool is_form = word.ends_with(ending) && !(ending == "s" && word.ends_with("ss"));
        if (is_form && word.size() >= kShortestStem + ending.size()) {
            word.remove_suffix(ending.size());
            break;
        }
    }
    const std::size_t n = word.size();
    const bool doubled = n > kShortestStem && word[n - 1] == word[n - 2];
    word.remove_suffix(doubled || (n > kShortestStem && word.back() == 'e') ? 1 : 0);
    return word;
}

/// How many words of `arc` were said; articles tell nothing.
int kept_words(const TemplateSet& set, const Graph& graph, const Arc& arc,
               const std::vector<std::string>& said) {
    const auto words = graph.said_by(arc);
    return static_cast<int>(std::count_if(words.begin(), words.end(), [&](int number) {
        const std::string& word = set.words.text(number);
        return !is_article(word) &&
               std::any_of(said.begin(), said.end(),
                           [&](const std::string& one) { return alike(word, one); });
    }));
}

}  // namespace

bool alike(std::string_view word, std::string_view other) {
    return word == other || stem_of(word) == stem_of(other);
}

namespace {

/// The slot that the arc fills, or kNone.
int slot_of(const Graph& graph, const Arc& arc) {
    return arc.element == kNone ? kNone
                                : graph.elements[static_cast<std::size_t>(arc.element)].slot;
}

}  // namespace

std::vector<Piece> canonical_pieces(const TemplateSet& set, int number,
                                    const std::vector<std::pair<std::string, std::string>>& slots,
                                    const std::vector<std::string>& said) {
    const Graph& graph = set.graphs[static_cast<std::size_t>(number)];
    const std::vector<int> wanted = wanted_entries(set, slots);
    const auto allowed = [&](const Arc& arc) {
        const int slot = slot_of(graph, arc);
        return arc.canonical &&
               (slot == kNone || wanted[static_cast<std::size_t>(slot)] == arc.item);
    };

    // The named slots must be in it; besides that, the fewest words: a slot is worth more than any sentence is long.
    constexpr int kSlotWorth = 1000;
    constexpr int kFar = std::numeric_limits<int>::max() / 2;
    const auto is_named = [&](int slot) {
        return std::any_of(slots.begin(), slots.end(), [&](const auto& named) {
            return named.first == set.slots[static_cast<std::size_t>(slot)];
        });
    };
    const auto price = [&](const Arc& arc) {
        const int slot = slot_of(graph, arc);
        const int kept = slot == kNone ? kept_words(set, graph, arc, said) : 0;
        // A word that is kept is worth more than it is long.
        return arc.word_count - 2 * kept - (slot != kNone && is_named(slot) ? kSlotWorth : 0);
    };
    std::vector<int> to_end(static_cast<std::size_t>(graph.nodes()), kFar);
    std::vector<const Arc*> next(static_cast<std::size_t>(graph.nodes()), nullptr);
    to_end.back() = 0;
    for (int node = graph.end() - 1; node >= 0; --node) {
        for (const Arc& arc : graph.arcs_from(node)) {
            const int rest = to_end[static_cast<std::size_t>(arc.to)];
            if (allowed(arc) && rest < kFar &&
                price(arc) + rest < to_end[static_cast<std::size_t>(node)]) {
                to_end[static_cast<std::size_t>(node)] = price(arc) + rest;
                next[static_cast<std::size_t>(node)] = &arc;
            }
        }
    }
    std::vector<Piece> pieces;
    for (int node = graph.start(); next[static_cast<std::size_t>(node)] != nullptr;
         node = next[static_cast<std::size_t>(node)]->to) {
        const Arc& arc = *next[static_cast<std::size_t>(node)];
        if (arc.element != kNone) {
            pieces.push_back(right_piece(set, graph, arc));
        }
    }
    resolve(pieces);
    return pieces;
}

PieceRange phrase_around(const std::vector<Piece>& pieces, int at) {
    const auto role = [&](int i) { return pieces[static_cast<std::size_t>(i)].element.role; };
    const auto opens = [&](int i) {
        return role(i) == Role::determiner || role(i) == Role::modifier;
    };
    const int count = static_cast<int>(pieces.size());
    PieceRange range{at, at + 1};
    // Forwards from an article to its noun or adjective.
    while (range.last < count && opens(range.last - 1) &&
           (opens(range.last) || role(range.last) == Role::adjective ||
            role(range.last) == Role::noun || role(range.last) == Role::word)) {
        ++range.last;
    }
    // Backwards from a noun or adjective to its article.
    while (range.first > 0 && opens(range.first - 1)) {
        --range.first;
    }
    return range;
}

PieceRange phrase_of_slot(const std::vector<Piece>& pieces, int slot) {
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        if (pieces[static_cast<std::size_t>(i)].element.slot == slot) {
            return phrase_around(pieces, i);
        }
    }
    return {};
}

PieceRange passive_around(const std::vector<Piece>& pieces, int at) {
    const auto passive = [&](int i) { return pieces[static_cast<std::size_t>(i)].element.passive; };
    PieceRange range{at, at + 1};
    while (range.first > 0 && passive(range.first - 1)) {
        --range.first;
    }
    while (range.last < static_cast<int>(pieces.size()) && passive(range.last)) {
        ++range.last;
    }
    return range;
}

namespace {

/// "No, it isn't" has a comma, "no moons" has none.
bool begins_clause(std::string_view part) {
    constexpr std::array<std::string_view, 12> kSubjects = {
        "it", "they", "this", "that", "the", "a", "an", "i", "we", "you", "he", "she"};
    std::string word = lower_case(part.substr(0, part.find(' ')));
    std::erase(word, '*');
    return std::find(kSubjects.begin(), kSubjects.end(), word) != kSubjects.end();
}

/// What parts `text` from the words `part` behind it.
std::string_view between(const std::string& text, std::string_view part) {
    const std::string first = lower_case(text);
    if (part.starts_with("n't")) {
        return "";
    }
    const bool yes = first == "yes" || first == "yeah";
    if (text.empty() || text.back() == '-') {
        return "";
    }
    return yes || ((first == "no" || first == "sure") && begins_clause(part)) ? ", " : " ";
}

/// "Hard, smooth and slippery": piece `at` is an adjective of a list of them, right behind another one.
bool goes_on_listing(const std::vector<Piece>& pieces, int at) {
    const auto is_listed = [](const Piece& piece) {
        return piece.element.role == Role::adjective && piece.element.slot != kNone &&
               piece.element.degree == Degree::positive;
    };
    int before = at - 1;
    while (before >= 0 && pieces[static_cast<std::size_t>(before)].right.empty()) {
        --before;
    }
    return before >= 0 && at < static_cast<int>(pieces.size()) &&
           is_listed(pieces[static_cast<std::size_t>(before)]) &&
           is_listed(pieces[static_cast<std::size_t>(at)]);
}

/// "Can't" and "won't" lose letters.
void shorten_before(std::string_view right, std::string& text) {
    if (right == "n't" && text.ends_with("an")) {
        text.pop_back();
    } else if (right == "n't" && text.ends_with("will")) {
        text.replace(text.size() - 3, 3, "o");
    }
}

}  // namespace

std::string render_phrase(const std::vector<Piece>& pieces, PieceRange range) {
    std::string text;
    for (int i = range.first; i < range.last; ++i) {
        const std::string& right = pieces[static_cast<std::size_t>(i)].right;
        if (!right.empty()) {
            text += !text.empty() && goes_on_listing(pieces, i) ? ", " : between(text, right);
            shorten_before(right, text);
            text += right == "i" ? "I" : right;
        }
    }
    return text;
}

std::string render(const std::vector<Piece>& pieces, PieceRange mark, bool blank) {
    const int count = static_cast<int>(pieces.size());
    // "Does" of "doesn't" is no word of its own.
    while (mark.first < mark.last && mark.last < count &&
           pieces[static_cast<std::size_t>(mark.last)].right.starts_with("n't")) {
        ++mark.last;
    }
    std::string head = render_phrase(pieces, {0, mark.first});
    std::string middle = render_phrase(pieces, mark);
    const std::string tail = render_phrase(pieces, {mark.last, count});
    // The capital goes inside the asterisks.
    (head.empty() ? middle : head) = sentence_case(head.empty() ? middle : head);
    if (!middle.empty()) {
        middle = blank ? std::string(kGap) : "*" + middle + "*";
    }
    std::string text;
    for (const auto& [part, first] :
         {std::pair{head, 0}, std::pair{middle, mark.first}, std::pair{tail, mark.last}}) {
        if (!part.empty()) {
            text += !text.empty() && goes_on_listing(pieces, first) ? ", " : between(text, part);
            text += part;
        }
    }
    const bool open = text.size() >= kGap.size() && text.substr(text.size() - kGap.size()) == kGap;
    return sentence_case(text) + (asks(text) ? "?" : open ? "" : ".");
}

Sample walk_plainly(const TemplateSet& set, int number, bool error,
                    const std::function<std::size_t(std::size_t)>& choose) {
    const Graph& graph = set.graphs[static_cast<std::size_t>(number)];
    const std::vector<bool> leads = leads_plainly(graph);
    Sample sample;
    bool wanted = error;
    int node = graph.start();
    while (node != graph.end() && leads[static_cast<std::size_t>(node)]) {
        std::vector<const Arc*> right;
        std::vector<const Arc*> wrong;
        for (const Arc& arc : graph.arcs_from(node)) {
            if (leads[static_cast<std::size_t>(arc.to)] &&
                (is_plain(arc) || arc.code != ErrorCode::none)) {
                (is_plain(arc) ? right : wrong).push_back(&arc);
            }
        }
        constexpr std::size_t kOneIn = 3;  // so that errors come at all places
        const bool errs = wanted && !wrong.empty() && (right.empty() || choose(kOneIn) == 0);
        const std::vector<const Arc*>& ways = errs ? wrong : right;
        wanted = wanted && !errs;
        node = go_on(set, graph, *ways[choose(ways.size()) % ways.size()], sample);
    }
    resolve(sample.pieces);
    describe(set, error, sample);
    return sample;
}

Sample walk(const TemplateSet& set, int number, bool errors,
            const std::function<std::size_t(std::size_t)>& choose) {
    const Graph& graph = set.graphs[static_cast<std::size_t>(number)];
    const std::vector<bool> leads = leads_to_end(graph, errors);
    Sample sample;
    int node = graph.start();
    while (node != graph.end()) {
        std::vector<const Arc*> ways;
        for (const Arc& arc : graph.arcs_from(node)) {
            if ((errors || arc.code == ErrorCode::none) &&
                leads[static_cast<std::size_t>(arc.to)]) {
                ways.push_back(&arc);
            }
        }
        node = go_on(set, graph, *ways[choose(ways.size()) % ways.size()], sample);
    }
    resolve(sample.pieces);
    describe(set, errors, sample);
    return sample;
}

}  // namespace fulcrum::dialogue
