// A file of sorted lines, such as dictionaries have, looked at where it lies: no line is read before it is asked for.
//
// Thread: immutable once open, so any.  Cost: `open` maps the file; a look-up is a bisection, some 20 lines touched.
#pragma once

#include "dialogue/result.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace fulcrum::dialogue {

/// Lines in the order of their bytes, each with "\n" at its end.
class SortedLines {
  public:
    /// Opens `path`; an error names the file and the Debian package that has it.
    [[nodiscard]] static Expected<SortedLines> open(const std::string& path,
                                                    std::string_view package);

    SortedLines(SortedLines&& other) noexcept;
    SortedLines& operator=(SortedLines&& other) noexcept;
    SortedLines(const SortedLines&) = delete;
    SortedLines& operator=(const SortedLines&) = delete;
    ~SortedLines();

    /// All lines that begin with `prefix`, as one text with their line ends; empty when there are none.
    [[nodiscard]] std::string_view starting_with(std::string_view prefix) const;
    [[nodiscard]] std::string_view text() const { return text_; }

  private:
    explicit SortedLines(std::string_view text) : text_(text) {}
    /// The start of the first line that isn't before `prefix`; with `behind`, of the first that is behind all that begin with it.
    [[nodiscard]] std::size_t find(std::string_view prefix, bool behind) const;

    std::string_view text_;  ///< mapped
};

}  // namespace fulcrum::dialogue
