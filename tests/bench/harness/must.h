// What a benchmark cannot go on without.
#pragma once

#include "haptics/base/error.h"

#include <stdexcept>
#include <type_traits>
#include <utility>

namespace fulcrum::bench {

/// The value; where there is none, ends the benchmark with the error's sentence, or what dialogue says of a text.
template <class T, class E>
T must(tl::expected<T, E> result) {
    if (!result) {
        if constexpr (std::is_same_v<E, Error>) {
            throw std::runtime_error(to_sentence(result.error()));
        } else {
            throw std::runtime_error(result.error().message);
        }
    }
    if constexpr (!std::is_void_v<T>) {
        return std::move(*result);
    }
}

}  // namespace fulcrum::bench
