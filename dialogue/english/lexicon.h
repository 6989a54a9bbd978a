// Which kinds of word a word can be, how often it is each, and the word it is a form of: mice, mouse; heavier, heavy.
//
// The words are WordNet's, its exception lists name the irregular forms, and its counts of tagged texts tell that "moon"
// is a noun though it can be a verb. They are looked at where Debian's package wordnet-base puts them.
//
// Thread: immutable once open, so any.  Cost: `open` maps ten files, nothing is read; a word takes some bisections.
// Source: Miller 1995, "WordNet: a lexical database for English", Communications of the ACM 38(11); the manual pages
//   morphy(7WN) (rules of detachment), wndb(5WN) and cntlist(5WN) (files).
#pragma once

#include "dialogue/english/sorted_lines.h"
#include "dialogue/result.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// The open kinds of word.
enum class WordKind : std::uint8_t { noun, verb, adjective, adverb };
inline constexpr std::array kWordKinds = {WordKind::noun, WordKind::verb, WordKind::adjective,
                                          WordKind::adverb};

inline constexpr std::string_view kWordNetFolder = "/usr/share/wordnet";

/// WordNet's words.
class Lexicon {
  public:
    /// An error names the file that is missing and its package.
    [[nodiscard]] static Expected<Lexicon> open(std::string_view folder = kWordNetFolder);

    /// Is `word` (lower case) itself an entry of that kind? Forms are not: "mouse", not "mice".
    [[nodiscard]] bool has(std::string_view word, WordKind kind) const;
    /// How often the entry stands in the tagged texts as that kind; 0 when never.
    [[nodiscard]] int count(std::string_view word, WordKind kind) const;
    /// The entries that `word` is an inflected form of, without itself: "mice" {"mouse"}, "better" {"good", "well"}.
    [[nodiscard]] std::vector<std::string> bases(std::string_view word, WordKind kind) const;
    /// Irregular plurals of the exception list: "foot" {"feet"}; empty for a regular noun.
    [[nodiscard]] std::vector<std::string> irregular_plurals(std::string_view noun) const;

  private:
    Lexicon(std::vector<SortedLines> indexes, std::vector<SortedLines> exceptions,
            SortedLines counts);

    std::vector<SortedLines> indexes_;     ///< by kind
    std::vector<SortedLines> exceptions_;  ///< by kind
    SortedLines counts_;
    std::multimap<std::string, std::string, std::less<>> plurals_;  ///< foot -> feet
};

}  // namespace fulcrum::dialogue
