// A free sentence as the rules see it: its words, what each can be, and where clauses begin and end.
//
// Thread: immutable once read, so any.  Cost: some bisections of the lexicon a word; at most kMostFreeWords words.
#pragma once

#include "dialogue/english/adjective.h"
#include "dialogue/english/lexicon.h"
#include "dialogue/english/noun.h"

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr std::size_t kLongestFreeText_bytes = 1000;  ///< what is behind is not looked at
inline constexpr int kMostFreeWords = 40;  ///< of one sentence; in longer ones nothing is marked

/// Counted less often, a word with a capital may be anybody's name.
inline constexpr int kPlainWord = 5;

/// One word and all that it can be.
struct FreeWord {
    std::string text;     ///< lower case, without apostrophes; contractions are parted
    std::string written;  ///< the letters as they stand
    std::size_t begin = 0;
    std::size_t end = 0;      ///< bytes of the text, [begin, end)
    bool closed = false;      ///< a word of grammar: the, she, with, is, not
    bool known = false;       ///< in the lexicon, itself or as a form
    bool capital = false;     ///< begins with one
    bool possessive = false;  ///< the 's of "the moon's side"
    bool number = false;      ///< a number word or digits, more than one
    bool thing = false;  ///< names a thing that stands before the learner, one that can be counted
    bool behind_stop = false;  ///< first of the sentence, or behind a comma, a semicolon or a colon
    bool hyphen_behind = false;    ///< joined to the next word by a hyphen: "function-like"
    bool before_stop = false;      ///< last of the sentence, or before one of those
    std::string singular{};        ///< a noun in the plural: its singular
    bool can_be_singular = false;  ///< a noun that stands as it is in the lexicon
    std::string verb{};            ///< a verb: its plain form, "go" of go and goes
    bool verb_in_s = false;        ///< goes, has, is
    bool verb_plain = false;       ///< go, have
    std::string adjective{};       ///< an adjective: its positive, "heavy" of heavier
    Degree degree = Degree::positive;
    std::string adverb_of{};  ///< an adverb in -ly: its adjective
    int noun_count = 0, verb_count = 0, adjective_count = 0, adverb_count = 0;

    /// Much more a noun than anything else.
    [[nodiscard]] bool mainly_noun() const;
    [[nodiscard]] bool mainly_verb() const;
    /// Much more an adjective, in any degree.
    [[nodiscard]] bool mainly_adjective() const;
    /// A countable noun in the singular that is hardly anything else; not water, not people.
    [[nodiscard]] bool singular_noun() const;
    /// A noun in the plural that is hardly anything else.
    [[nodiscard]] bool plural_noun() const;
};

/// One sentence of a text.
class FreeSentence {
  public:
    FreeSentence(std::vector<FreeWord> words, bool asks) : words_(std::move(words)), asks_(asks) {}

    [[nodiscard]] int size() const { return static_cast<int>(words_.size()); }
    /// The word at `i`; an empty one outside.
    [[nodiscard]] const FreeWord& operator[](int i) const;
    [[nodiscard]] const std::string& text(int i) const { return (*this)[i].text; }
    [[nodiscard]] bool is(int i, std::initializer_list<std::string_view> words) const;
    /// Ends with a question mark.
    [[nodiscard]] bool asks() const { return asks_; }
    /// A form of the verb `plain` stands before `i`.
    [[nodiscard]] bool has_before(int i, std::string_view plain) const;
    /// The word at `i` joins a clause to what is before it: but, because, when, …; "as" only where it compares nothing.
    [[nodiscard]] bool joins_clauses(int i) const;
    /// A clause begins at `i`: the sentence, behind a stop, or behind "but", "because", "I think (that)", …
    [[nodiscard]] bool clause_begins(int i) const;
    /// Nothing of the phrase comes behind `i`: a stop or the end.
    [[nodiscard]] bool ends_at(int i) const { return i + 1 >= size() || (*this)[i].before_stop; }
    /// Behind a noun at `i` no noun follows that it would belong to: "car" of "car door" is no head.
    [[nodiscard]] bool is_head(int i) const;
    /// A finite verb stands at `i` or behind it, as far as that is certain.
    [[nodiscard]] bool has_verb_from(int i) const;
    /// A form of "be" that is finite.
    [[nodiscard]] bool be_at(int i) const;

  private:
    std::vector<FreeWord> words_;
    bool asks_;
};

/// The sentences of `text`. `things` are the nouns, in small letters, of what stands before whoever said it: there "egg" is one egg, and
/// not what an egg is made of.
[[nodiscard]] std::vector<FreeSentence> read_sentences(const Lexicon& lexicon,
                                                       std::string_view text,
                                                       std::span<const std::string> things = {});

}  // namespace fulcrum::dialogue
