// What a template or catalogue author wrote that cannot work, and the result type of everything here that is loaded.
// The dialogue library stands alone, so it has its own small error.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace fulcrum::dialogue {

/// A mistake in a text that a person wrote: a template, a list, a catalogue.
struct Error {
    std::string message;  ///< what is wrong and what to do, one clause without a full stop
    int column = 0;       ///< where in that text, counted in bytes from 1; 0 when there is no place
    int line = 0;         ///< the text's line, counted from 1; 0 for a text of one line
};

template <class T>
using Expected = tl::expected<T, Error>;

/// Makes the failed side of an `Expected`.
[[nodiscard]] tl::unexpected<Error> fail(std::string_view message, int column = 0, int line = 0);

/// The parts of a sentence, joined.
[[nodiscard]] std::string concat(std::initializer_list<std::string_view> parts);

}  // namespace fulcrum::dialogue
