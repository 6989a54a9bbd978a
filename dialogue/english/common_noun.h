// Whether a word with a capital is a name or a common noun: "Apple" is none, "Mars" is one.
//
// WordNet writes names with a capital, and has the senses of a word in the order of how often it is meant: a common noun is one whose
// first sense has it in small letters alone. So "Sun" and "May" are names, and "Wood" is a common noun though people are called so.
//
// Thread: immutable once open, so any.  Cost: `open` maps two files; a word takes a bisection and one line.
// Source: the manual page wndb(5WN), index and data files.
#pragma once

#include "dialogue/english/lexicon.h"
#include "dialogue/english/sorted_lines.h"
#include "dialogue/result.h"

#include <string_view>
#include <utility>

namespace fulcrum::dialogue {

class CommonNouns {
  public:
    /// An error names the file that is missing and its package.
    [[nodiscard]] static Expected<CommonNouns> open(std::string_view folder = kWordNetFolder);

    /// Is the one word `word`, in any letters, foremost a common noun?
    [[nodiscard]] bool has(std::string_view word) const;

  private:
    CommonNouns(SortedLines index, SortedLines data)
        : index_(std::move(index)), data_(std::move(data)) {}

    SortedLines index_;
    SortedLines data_;
};

}  // namespace fulcrum::dialogue
