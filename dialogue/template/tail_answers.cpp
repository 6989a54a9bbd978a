#include "dialogue/template/tail_answers.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/phrases.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/short_answers.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace fulcrum::dialogue {
namespace {

using Kind = SyntaxNode::Kind;

/// A sentence cut in two.
struct Cut {
    std::string head;      ///< "the apple is"
    std::string tail;      ///< "<place>"
    bool is_thing = true;  ///< "it" may stand for what the head is about
    SubjectNumber number = SubjectNumber::unknown;
};

/// Looks for the place where a sentence may be cut.
class Cutter {
  public:
    Cutter(const std::string& text, const Syntax& syntax, const ParsedRules& rules)
        : text_(text), syntax_(syntax), rules_(rules) {
        const SyntaxNode& whole = syntax_[0];
        if (whole.kind == Kind::alternatives && whole.children.size() == 1) {
            parts_ = node(whole.children[0]).children;
        }
    }

    [[nodiscard]] std::optional<Cut> find() const {
        // The verb behind "there" goes with what is counted behind it: there a head is not the same for all tails.
        if (parts_.empty() || asks() || is_word(parts_[0], "there")) {
            return std::nullopt;
        }
        for (std::size_t i = 1; i < parts_.size(); ++i) {
            if (asks_for_more(parts_[i - 1])) {
                return std::nullopt;  // the head has a word of its own to choose
            }
            const bool behind_be = i > 1 && is_be(parts_[i - 1]);
            if ((behind_be && !is_plain(i)) || is_last_rule(i)) {
                return cut_at(i);
            }
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] const SyntaxNode& node(int index) const {
        return syntax_[static_cast<std::size_t>(index)];
    }

    /// A part of the sentence without brackets that hold nothing else.
    [[nodiscard]] const SyntaxNode& bare(int index) const {
        const SyntaxNode* part = &node(index);
        while ((part->kind == Kind::sequence || part->kind == Kind::alternatives) &&
               part->children.size() == 1) {
            part = &node(part->children[0]);
        }
        return *part;
    }

    [[nodiscard]] bool is_word(int index, std::string_view word) const {
        return bare(index).kind == Kind::word && bare(index).text == word;
    }

    /// "is", "are", "(is|lies)".
    [[nodiscard]] bool is_be(int index) const {
        const SyntaxNode& part = bare(index);
        if (part.kind != Kind::alternatives) {
            return is_word(index, "is") || is_word(index, "are");
        }
        return std::ranges::any_of(part.children,
                                   [&](int child) { return is_word(child, "is"); }) &&
               std::ranges::all_of(part.children,
                                   [&](int child) { return bare(child).kind == Kind::word; });
    }

    /// A list or a rule of the author's stands in it.
    [[nodiscard]] bool asks_for_more(int index) const {
        std::vector<int> rest{index};
        while (!rest.empty()) {
            const SyntaxNode& part = node(rest.back());
            rest.pop_back();
            if (part.kind == Kind::list ||
                (part.kind == Kind::rule && rules_.contains(part.text))) {
                return true;
            }
            rest.insert(rest.end(), part.children.begin(), part.children.end());
        }
        return false;
    }

    /// From part `first` on nothing is to be chosen but a noun, for which there are short answers already.
    [[nodiscard]] bool is_plain(std::size_t first) const {
        const std::size_t n = parts_.size() - first;
        const bool is_noun = bare(parts_.back()).kind == Kind::list &&
                             (n == 1 || (n == 2 && !asks_for_more(parts_[first])));
        const auto chooses = [&](int part) { return asks_for_more(part); };
        return is_noun || std::none_of(parts_.begin() + static_cast<std::ptrdiff_t>(first),
                                       parts_.end(), chooses);
    }

    /// A rule at the end, behind neither article nor preposition: what follows them is no answer alone.
    [[nodiscard]] bool is_last_rule(std::size_t i) const {
        const SyntaxNode& before = bare(parts_[i - 1]);
        const SyntaxNode& part = bare(parts_[i]);
        return i + 1 == parts_.size() && part.kind == Kind::rule && rules_.contains(part.text) &&
               before.kind == Kind::word && !is_article(before.text) &&
               !is_preposition(before.text);
    }

    /// The learner is to ask: a question's end is none of its answers.
    [[nodiscard]] bool asks() const {
        constexpr std::array<std::string_view, 12> kAsking = {"how", "what",  "which", "where",
                                                              "who", "whose", "why",   "when",
                                                              "is",  "are",   "does",  "can"};
        return std::ranges::find(kAsking, bare(parts_[0]).text) != kAsking.end();
    }

    [[nodiscard]] Cut cut_at(std::size_t i) const {
        constexpr std::array<std::string_view, 7> kNoThing = {"i",   "you",   "we",  "he",
                                                              "she", "there", "here"};
        const auto column = static_cast<std::size_t>(node(parts_[i]).column) - 1;
        Cut cut{text_.substr(0, column), text_.substr(column)};
        const SyntaxNode& subject = bare(parts_[i > 1 ? i - 2 : 0]);
        cut.is_thing = is_be(parts_[i - 1]) &&
                       std::ranges::find(kNoThing, bare(parts_[0]).text) == kNoThing.end();
        if (subject.kind == Kind::word) {
            const bool several = is_word(parts_[i - 1], "are") || subject.text == "they" ||
                                 looks_plural(subject.text);
            cut.number = several ? SubjectNumber::plural : SubjectNumber::singular;
        }
        return cut;
    }

    const std::string& text_;
    const Syntax& syntax_;
    const ParsedRules& rules_;
    std::vector<int> parts_;
};

/// Writes the short answers of one sentence.
class TailWriter {
  public:
    TailWriter(TemplateSet& set, const ParsedRules& rules, int sentence)
        : set_(set), rules_(rules), sentence_(sentence) {}

    /// "Next to the bowl.", which a recast completes; false where it would not say all that is asked for, or has no room.
    bool add_tail(const Cut& cut) {
        const auto head = build_sentence(set_, rules_, cut.head);
        const auto syntax = parse_template(cut.tail);
        if (!head || !syntax || !has_room()) {
            return false;
        }
        ArcWriter writer(set_, arcs_left(set_));
        const int start = writer.add_node();
        const int behind = writer.add_node();
        writer.add_arc(start, behind, writer.add_element({}),
                       {.said = "", .right = said_rightly(head->graph), .canonical = true});
        GraphBuilder builder(set_, writer, rules_);
        const auto built = builder.build(*syntax, behind);
        if (!built || writer.full() || (own().required & ~built->required) != 0) {
            return false;
        }
        const int end = writer.add_node();
        writer.join(built->to, end);
        BuiltSentence sentence{writer.finish(start, end), {}};
        sentence.graph.slots = built->slots;
        sentence.graph.required = built->required;
        sentence.graph.definite = built->definite;
        if (may_be_empty(sentence.graph)) {
            return false;
        }
        keep(std::move(sentence.graph));
        return true;
    }

    /// "It is next to the bowl."
    void add_it(const Cut& cut) {
        if (!has_room()) {
            return;
        }
        if (auto sentence = build_sentence(set_, rules_, "<it> is " + cut.tail, cut.number)) {
            keep(std::move(sentence->graph));
        }
    }

  private:
    [[nodiscard]] const Graph& own() const {
        return set_.graphs[static_cast<std::size_t>(sentence_)];
    }
    /// What is short for a sentence has hardly more arcs than that.
    [[nodiscard]] bool has_room() const { return arcs_left(set_) > 2 * own().arcs.size(); }

    /// The words that a recast has for `graph`.
    std::string said_rightly(const Graph& graph) {
        set_.graphs.push_back(graph);
        const std::vector<Piece> pieces =
            canonical_pieces(set_, static_cast<int>(set_.graphs.size()) - 1, {});
        set_.graphs.pop_back();
        return render_phrase(pieces, {0, static_cast<int>(pieces.size())});
    }

    void keep(Graph graph) {
        graph.short_answer = true;
        graph.answer = sentence_;
        set_.graphs.push_back(std::move(graph));
    }

    TemplateSet& set_;
    const ParsedRules& rules_;
    int sentence_;
};

}  // namespace

void add_tail_answers(TemplateSet& set, const ParsedRules& rules,
                      const std::vector<std::string>& sentences) {
    std::vector<std::string> done;  // two sentences may end alike
    for (std::size_t i = 0; i < sentences.size(); ++i) {
        const auto syntax = parse_template(sentences[i]);
        const auto cut = syntax ? Cutter(sentences[i], *syntax, rules).find() : std::nullopt;
        if (!cut || std::ranges::find(done, cut->tail) != done.end()) {
            continue;
        }
        TailWriter writer(set, rules, static_cast<int>(i));
        if (writer.add_tail(*cut)) {
            done.push_back(cut->tail);
            if (cut->is_thing) {
                writer.add_it(*cut);
            }
        }
    }
}

}  // namespace fulcrum::dialogue
