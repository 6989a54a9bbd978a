// What tests ask of what may be refused, and of texts.
#pragma once

#include "haptics/base/error.h"

#include <catch2/catch.hpp>

#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace fulcrum {

/// An error as its sentence.
template <class E>
[[nodiscard]] std::string sentence_of(const E& error) {
    if constexpr (requires { to_sentence(error); }) {
        return to_sentence(error);
    } else {
        return error.message;
    }
}

/// The value; where there is none the test ends with the sentence that says why.
template <class T, class E>
[[nodiscard]] T value_of(tl::expected<T, E> made) {
    if (!made) {
        throw std::runtime_error(sentence_of(made.error()));
    }
    return std::move(*made);
}

/// The value; where there is none the test ends.
template <class T>
[[nodiscard]] T value_of(std::optional<T> found) {
    return std::move(found.value());
}

/// Why there is none; where there is one the test ends.
template <class T, class E>
[[nodiscard]] E error_of(const tl::expected<T, E>& made) {
    if (made) {
        throw std::runtime_error("this was to be refused, and was not");
    }
    return made.error();
}

/// The sentence that says why there is none; "" where there is one.
template <class T, class E>
[[nodiscard]] std::string refusal_of(const tl::expected<T, E>& made) {
    return made ? "" : sentence_of(made.error());
}

/// Checks that each of the words stands in the text. (Clang 14 has no std::source_location.)
inline void check_says(std::string_view text, std::initializer_list<std::string_view> words,
                       const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    INFO(file << ":" << line);
    for (const std::string_view word : words) {
        CHECK_THAT(std::string(text), Catch::Contains(std::string(word)));
    }
}

/// Checks that none of the words stands in the text.
inline void check_lacks(std::string_view text, std::initializer_list<std::string_view> words,
                        const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    INFO(file << ":" << line);
    for (const std::string_view word : words) {
        CHECK_THAT(std::string(text), !Catch::Contains(std::string(word)));
    }
}

}  // namespace fulcrum
