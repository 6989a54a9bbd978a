// A sentence template as a graph of words: what may be said, right or wrong, and what belongs there instead.
//
//   start --"a" right-->  o --"watermelon"--> o --"is"--> o --"the"--> o --"heaviest" right------------> end
//         --nothing M:DET->                                             --"most heavy" R:ADJ:FORM------->
//
// The graph has no cycle. A path from start to end is a sentence; the arcs without an error code make the right sentences;
// the others are what learners say. A recogniser listens for the same graph, so one template serves both.
//
// Thread: immutable once compiled, so any.  Cost: size is bounded by `kLargestGraph_arcs`.
#pragma once

#include "dialogue/english/adjective.h"
#include "dialogue/english/error_code.h"
#include "dialogue/english/noun.h"
#include "dialogue/english/verb.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr std::size_t kLargestGraph_arcs =
    20'000;  ///< of all graphs of one template set together
inline constexpr std::size_t kMostSlots = 16;
inline constexpr int kNone = -1;

/// Strings by number, each once.
class StringTable {
  public:
    /// The number of `text`, new if need be.
    int intern(std::string_view text);
    /// The number of `text`, or kNone.
    [[nodiscard]] int find(std::string_view text) const;
    [[nodiscard]] const std::string& text(int number) const {
        return texts_[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] int size() const { return static_cast<int>(texts_.size()); }

  private:
    std::vector<std::string> texts_;
    std::map<std::string, int, std::less<>> numbers_;
};

/// The part that an arc plays in its sentence.
enum class Role : std::uint8_t {
    word,
    determiner,
    noun,
    adjective,
    modifier,
    verb,
    preposition,
    pronoun,
    conjunction
};

/// One place of a template; all arcs for that place share it.
struct Element {
    Role role = Role::word;
    int slot = kNone;    ///< noun or adjective: the slot it fills
    std::string base{};  ///< adjective or counted noun: the word of the form, e.g. "heavy"
    Degree degree = Degree::positive;  ///< adjective
    VerbForms verb{};                  ///< verb
    bool target = false;               ///< a form that the question teaches
    bool passive = false;              ///< part of "is made of"
    bool brings_article =
        false;  ///< noun: said without the article that belongs to it, "apples" for "an apple"
};

/// One step of a sentence: some words that may be said at a place.
struct Arc {
    int from = 0;
    int to = 0;
    int element = kNone;  ///< kNone: an arc that stands for nothing
    int first_word = 0;   ///< in `Graph::said`
    int word_count = 0;   ///< 0: nothing is said
    int right = kNone;  ///< what belongs here, a number of `TemplateSet::texts`; kNone when nothing
    ErrorCode code = ErrorCode::none;
    int cost = 0;                      ///< 0 for what is right
    int item = kNone;                  ///< noun or adjective: the entry of the slot's list
    Number number = Number::singular;  ///< noun
    bool canonical = false;            ///< part of the sentence that a recast gives
};

/// What is said, measured by what the author's answer says with the same words.
enum class Claim : std::uint8_t {
    same,      ///< as much: "the apple is heavier", "the egg is not as heavy as the apple"
    contrary,  ///< the contrary, an answer as well: "metal is not soft"
    excluded,  ///< the contrary, which leaves open what is asked: "the egg is not the heaviest"
    of_none,   ///< that no word is right: "they weigh the same"
    of_any,    ///< that some word is right: "on top", of whatever that is
    every,     ///< of several sentences: each of them, see marking/mark_answer.h
    reasoned   ///< an answer and the reason given for it, see marking/reasons.h
};

/// One template, compiled. Nodes are numbered in an order in which every arc goes upwards.
struct Graph {
    std::vector<Arc> arcs;       ///< ordered by `from`
    std::vector<int> first_arc;  ///< by node, one more than there are nodes
    std::vector<Element> elements;
    std::vector<int> said;       ///< word numbers, arc after arc
    std::vector<bool> says;      ///< by word number: whether some arc says it
    std::uint32_t slots = 0;     ///< bit i: slot i can be filled
    std::uint32_t required = 0;  ///< bit i: slot i is filled in every sentence
    std::uint32_t definite = 0;  ///< bit i: slot i stands behind "the": one thing that is there
    bool short_answer = false;   ///< "The watermelon."
    bool whole_sentence = true;  ///< false for a noun alone: a recast completes it
    bool nearly = false;         ///< understood, but no good English: `answer` says it rightly
    bool turned_round =
        false;           ///< "Metal is made of a spaceship.": thing and material change places
    int answer = kNone;  ///< the answer that this is, or is short for
    Claim claim = Claim::same;
    int about = kNone;  ///< of another claim: the slot whose words it is about
    std::vector<int>
        answers;  ///< of what is nearly one: all answers that mean the same; `answer` is the first

    [[nodiscard]] int nodes() const { return static_cast<int>(first_arc.size()) - 1; }
    [[nodiscard]] int start() const { return 0; }
    [[nodiscard]] int end() const { return nodes() - 1; }
    /// The arcs that leave `node`.
    [[nodiscard]] std::span<const Arc> arcs_from(int node) const {
        const auto first = static_cast<std::size_t>(first_arc[static_cast<std::size_t>(node)]);
        const auto last = static_cast<std::size_t>(first_arc[static_cast<std::size_t>(node) + 1]);
        return std::span<const Arc>(arcs).subspan(first, last - first);
    }
    /// The words of `arc`, as numbers of `TemplateSet::words`.
    [[nodiscard]] std::span<const int> said_by(const Arc& arc) const {
        return std::span<const int>(said).subspan(static_cast<std::size_t>(arc.first_word),
                                                  static_cast<std::size_t>(arc.word_count));
    }
};

/// An entry of a list: its value, and the nouns that are said for it (the first is what a recast says).
struct ListItem {
    std::string value;
    std::vector<Noun> spoken;
};

/// A named list of entries.
struct WordList {
    std::string name;
    std::vector<ListItem> items;
};

/// The templates of one question, compiled together: they share words, lists and slots.
struct TemplateSet {
    StringTable words;
    StringTable texts;  ///< right texts, as they are shown
    std::vector<std::uint8_t>
        standing;  ///< by word: 2 in a recast's sentence, 1 elsewhere, 0 a misspelling; see matcher
    std::vector<WordList> lists;
    std::vector<std::string>
        slots;  ///< names; a name may come again for what is turned round, from another list
    std::vector<int> slot_lists;  ///< by slot: the list that fills it
    std::vector<Graph>
        graphs;       ///< the answers in order, then what is nearly one, then short answers
    int answers = 0;  ///< how many of `graphs` are whole answers
};

}  // namespace fulcrum::dialogue
