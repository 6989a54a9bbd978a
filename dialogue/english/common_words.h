// Which English words are common, from a list of them.
//
// A word is common when it, or what it may be a regular form of, stands in the list: "hedges" by "hedge", "biggest" by "big", "tried" by
// "try". It is read as Americans spell it, too: "colour" by "color", "metre" by "meter".
//
// Thread: immutable once made, so any.  Cost: some look-ups a word.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

class CommonWords {
  public:
    /// A list: a word a line; a line that begins with # is none.
    explicit CommonWords(std::string_view list);

    /// Adds the words of a text, as taught or known otherwise.
    void add(std::string_view text);
    [[nodiscard]] bool has(std::string_view word) const;
    /// The words of a text that are not common, each once, in order. Names are left out: words with a capital letter within a sentence.
    [[nodiscard]] std::vector<std::string> rare_words(std::string_view text) const;

  private:
    std::set<std::string, std::less<>> words_;
};

}  // namespace fulcrum::dialogue
