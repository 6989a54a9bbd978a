// All that a learner reads or hears, in one text file a language: never a string in the code.
//
//   # a comment
//   feedback.recast = Yes. {sentence}
//
// Keys are of a-z 0-9 _ and '.'; a text may hold {slots} that the program fills; \n is a new line.
//
// Thread: immutable once parsed, so any.  Cost: a look-up in a map a text.
#pragma once

#include "dialogue/result.h"

#include <functional>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// Names and values for a text's slots.
using CatalogueSlots = std::vector<std::pair<std::string_view, std::string>>;

/// A key that the program uses, with the slots it fills.
struct CatalogueNeed {
    std::string_view key;
    std::vector<std::string_view> slots;
};

/// The texts of one language.
class Catalogue {
  public:
    /// Parses a catalogue's file; an error has line and column.
    [[nodiscard]] static Expected<Catalogue> parse(std::string_view text);

    /// The text of `key` with its slots filled. An error names a missing key, or a slot in the text that isn't given.
    [[nodiscard]] Expected<std::string> text(std::string_view key,
                                             const CatalogueSlots& slots = {}) const;

    /// As `text`, for the running program: what is missing is shown as its key, "[menu.start]", rather than not at all.
    [[nodiscard]] std::string say(std::string_view key, const CatalogueSlots& slots = {}) const;

    /// The text for so many things: of `key`.one where the language has a form for one (language.plurals: one other), else of
    /// `key`.other.
    [[nodiscard]] std::string say_counted(std::string_view key, long count,
                                          const CatalogueSlots& slots = {}) const;

    /// Takes over what only the other has.
    void fill_from(const Catalogue& other) {
        texts_.insert(other.texts_.begin(), other.texts_.end());
    }

    /// True when there is such a key.
    [[nodiscard]] bool has(std::string_view key) const { return texts_.find(key) != texts_.end(); }

    /// The keys prefix.1, prefix.2, … as far as they go.
    [[nodiscard]] std::vector<std::string> series(std::string_view prefix) const;

    /// All keys, in order.
    [[nodiscard]] std::vector<std::string> keys() const;

    /// Checks that every needed key is there and asks for no slot that the program doesn't fill.
    [[nodiscard]] Expected<bool> check(std::span<const CatalogueNeed> needs) const;

  private:
    std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace fulcrum::dialogue
