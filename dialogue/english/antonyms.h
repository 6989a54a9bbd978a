// Which words mean the opposite: heavy, light; push, pull; up, down. The pairs are WordNet's, of any kind of word, with a few that
// it has not, for it has no prepositions, and what negates a verb.
//
// For whoever looks a text over; what is marked while a learner waits has a table of its own (opposite.h).
//
// Thread: immutable once open, so any.  Cost: `open` maps eight files, nothing is read; a word takes some bisections.
// Source: Miller 1995, "WordNet: a lexical database for English", Communications of the ACM 38(11); the manual pages
//   wndb(5WN) (lines of index and data files) and wninput(5WN) (pointer symbol "!").
#pragma once

#include "dialogue/english/lexicon.h"

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// Pairs of opposites.
class Antonyms {
  public:
    /// An error names the file that is missing and its package.
    [[nodiscard]] static Expected<Antonyms> open(std::string_view folder = kWordNetFolder);

    /// What means the opposite of `word` (lower case) in one of its senses, in the same form, each once: "heavier" {"lighter"},
    /// "pulls" {"pushes"}, "is" {"isn't", "is not"}.
    [[nodiscard]] std::vector<std::string> of(std::string_view word) const;

  private:
    Antonyms(Lexicon lexicon, std::vector<SortedLines> indexes, std::vector<SortedLines> data);
    /// Of an entry, as that kind of word.
    [[nodiscard]] std::vector<std::string> of_entry(std::string_view entry, WordKind kind) const;

    Lexicon lexicon_;
    std::vector<SortedLines> indexes_;  ///< by kind
    std::vector<SortedLines> data_;     ///< by kind
};

}  // namespace fulcrum::dialogue
